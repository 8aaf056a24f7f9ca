//! Room for many points at once.
//!
//! Fresh memory is handed out page by page, each cleared when it is first written to, which in pages
//! of 4 kB takes several times as long as to read a cloud into them. The system is asked for huge
//! ones.

/// An empty vector with room for `capacity` items, of huge pages where it is large and the system
/// has them.
pub(crate) fn with_capacity<T>(capacity: usize) -> Vec<T> {
    let mut items = Vec::with_capacity(capacity);
    ask_for_huge_pages(items.spare_capacity_mut());
    items
}

#[cfg(all(target_os = "linux", not(miri)))]
fn ask_for_huge_pages<T>(memory: &mut [std::mem::MaybeUninit<T>]) {
    /// Bytes of memory for which it is worth to ask.
    const LARGE: usize = 1 << 22;
    /// Advice begins at a page. Where pages are larger than the usual, it may be refused.
    const PAGE: usize = 1 << 12;
    let bytes = size_of_val(memory);
    if bytes < LARGE {
        return;
    }
    let start = memory.as_mut_ptr().cast::<u8>();
    let before = start.addr() % PAGE;
    // SAFETY: the range lies in the pages of memory that is borrowed for as long as the call takes;
    // this advice changes none of their contents, not even beyond the ends of the memory. Where it
    // is refused, pages stay small.
    unsafe {
        libc::madvise(start.wrapping_sub(before).cast(), before + bytes, libc::MADV_HUGEPAGE);
    }
}

#[cfg(not(all(target_os = "linux", not(miri))))]
fn ask_for_huge_pages<T>(_memory: &mut [std::mem::MaybeUninit<T>]) {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn room_is_for_as_many_as_asked_and_holds_what_is_put_in() {
        for capacity in [0, 1, 1000, (1 << 19) - 1, 1 << 19, (1 << 19) + 1, 3 << 18] {
            let mut numbers = with_capacity::<f64>(capacity);
            let mut neighbours = with_capacity::<[f64; 3]>(capacity / 3);
            assert!(numbers.is_empty() && numbers.capacity() >= capacity);
            numbers.extend((0..capacity).map(|number| number as f64));
            neighbours.extend((0..capacity / 3).map(|number| [number as f64; 3]));
            assert!((0..capacity).all(|number| numbers[number] == number as f64));
            assert!((0..capacity / 3).all(|number| neighbours[number] == [number as f64; 3]));
        }
    }
}
