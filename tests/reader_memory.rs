//! Files that promise more than they hold take no memory for it.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

use superquadric::cloud::{read, read_stream};

/// The system's allocator, with a count of the bytes in use and of the most there ever were.
struct Counting;

static USED: AtomicUsize = AtomicUsize::new(0);
static PEAK: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is handed on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let used = USED.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        PEAK.fetch_max(used, Ordering::Relaxed);
        // SAFETY: the caller keeps the contract of `GlobalAlloc::alloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        USED.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: the caller keeps the contract of `GlobalAlloc::dealloc`.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// The most bytes in use while `work` ran beyond those before.
fn peak_of(work: impl FnOnce()) -> usize {
    let before = USED.load(Ordering::Relaxed);
    PEAK.store(before, Ordering::Relaxed);
    work();
    PEAK.load(Ordering::Relaxed) - before
}

const LIMIT: usize = 8 << 20;

const XYZ: &str = "property float x\nproperty float y\nproperty float z\nend_header\n";

/// Files that lie about how much there is.
fn lies() -> Vec<Vec<u8>> {
    let mut lies = Vec::new();
    for count in [1_u64 << 31, 1 << 32, 1 << 40, u64::MAX] {
        for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
            for element in [
                format!("element vertex {count}\n"),
                format!("element none {count}\nelement vertex {count}\n"),
                format!("element face {count}\nproperty list uint double l\nelement vertex 1\n"),
                format!("element vertex {count}\nproperty list uint double l\n"),
            ] {
                let header = format!("ply\nformat {encoding} 1.0\n{element}{XYZ}");
                lies.push([header.as_bytes(), &[0xff; 100]].concat());
            }
        }
        for data in ["ascii", "binary", "binary_compressed"] {
            for lengths in [1, 65536] {
                let header = format!(
                    "VERSION .7\nFIELDS x y z _\nSIZE 4 4 4 1\nTYPE F F F U\n\
                     COUNT 1 1 1 {lengths}\nPOINTS {count}\nDATA {data}\n"
                );
                lies.push([header.as_bytes(), &[0xff; 100]].concat());
            }
        }
        for order in ["True", "False"] {
            let header =
                format!("{{'descr': '<f8', 'fortran_order': {order}, 'shape': ({count}, 3)}}");
            let magic = [b"\x93NUMPY\x01\0".as_slice(), &[header.len() as u8, 0]].concat();
            lies.push([&magic, header.as_bytes(), &[0; 100]].concat());
        }
        lies.push(format!("{count}\n1 2 3\n").into_bytes());
    }
    // Headers that go on and on.
    let property = |number| format!("property float p{number}\n");
    let properties: String = (0..100_000).map(property).collect();
    let long_names = format!("property float {}\n", "n".repeat(60_000)).repeat(100);
    for lines in ["\n".repeat(10 << 20), "comment\n".repeat(1 << 20), properties, long_names] {
        lies.push(format!("ply\nformat ascii 1.0\nelement vertex 1\n{lines}{XYZ}").into_bytes());
    }
    let sizes = [40_u32, 2_147_483_640].map(u32::to_le_bytes).concat();
    let header = "VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nPOINTS 89478485\n\
                  DATA binary_compressed\n";
    lies.push([header.as_bytes(), &sizes, &[0xff; 40]].concat());
    lies
}

#[test]
fn lies_take_no_memory() {
    let file = tempfile::NamedTempFile::new().unwrap();
    for bytes in lies() {
        std::fs::write(file.path(), &bytes).unwrap();
        let path = file.path();
        let text = bytes[..bytes.len().min(300)].escape_ascii().to_string();
        let peak = peak_of(|| assert!(read(path).is_err(), "{text}"));
        assert!(peak < LIMIT, "{peak} for {text}");
        let peak = peak_of(|| assert!(read_stream("-", &bytes[..]).is_err(), "{text}"));
        assert!(peak < LIMIT, "{peak} for {text}");
    }
}
