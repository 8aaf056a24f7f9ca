//! Files that are written whole or not at all.

use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::Builder;
use thiserror::Error;

/// Names of open streams, and of folders of them, whatever is behind them.
const STREAMS: [&str; 4] = ["/dev/stdout", "/dev/stderr", "/dev/fd", "/proc"];

/// A file that could not be written.
#[derive(Debug, Error)]
#[error("cannot write {}: {source}", path.display())]
pub struct OutputError {
    /// The file asked for.
    pub path: PathBuf,
    /// What went wrong.
    pub source: io::Error,
}

/// Writes a file through `content`, which is handed a buffered writer.
///
/// What it writes goes to a temporary file in the same directory, which takes the place of
/// `path` when all has been written: whoever reads `path` finds the old content or the new, and
/// after an error the old. A replaced file hands on its permissions; a new one has those of the
/// process's umask. Links are followed. A pipe, a device or a standard stream by its name, such
/// as `/dev/stdout`, is written directly.
///
/// # Errors
/// If `content` fails, or the file cannot be created, written or replaced.
pub fn write_whole(
    path: impl AsRef<Path>,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), OutputError> {
    let path = path.as_ref();
    let written = match Target::of(path) {
        Ok(Target::Stream) => write_stream(path, content),
        Ok(Target::New(file)) => replace(&file, None, content),
        Ok(Target::Old(file, permissions)) => replace(&file, Some(permissions), content),
        Err(error) => Err(error),
    };
    written.map_err(|source| OutputError { path: path.to_path_buf(), source })
}

/// What a path names, links followed.
enum Target {
    /// Nothing that can be replaced.
    Stream,
    /// No file yet.
    New(PathBuf),
    /// A regular file and its permissions.
    Old(PathBuf, Permissions),
}

impl Target {
    fn of(path: &Path) -> io::Result<Self> {
        if STREAMS.iter().any(|stream| path.starts_with(stream)) {
            return Ok(Self::Stream);
        }
        match fs::metadata(path) {
            Ok(metadata) if metadata.is_file() => {
                Ok(Self::Old(fs::canonicalize(path)?, metadata.permissions()))
            }
            Ok(metadata) if metadata.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
            Ok(_) => Ok(Self::Stream),
            // A link to nothing: the file it names is made through it.
            Err(_) if path.is_symlink() => Ok(Self::Stream),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Self::New(path.into())),
            Err(error) => Err(error),
        }
    }
}

/// Writes at the end of a stream: a file behind `/dev/stdout` keeps what it holds.
fn write_stream(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    fill(&OpenOptions::new().append(true).create(true).open(path)?, content)
}

/// Writes a temporary file beside `file` and renames it.
fn replace(
    file: &Path,
    permissions: Option<Permissions>,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let directory = match file.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    };
    let temporary = new_file_builder().tempfile_in(directory)?;
    fill(temporary.as_file(), content)?;
    if let Some(permissions) = permissions {
        temporary.as_file().set_permissions(permissions)?;
    }
    temporary.persist(file)?;
    Ok(())
}

/// Runs `content` on a buffer before a file, and empties the buffer.
fn fill(file: &File, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut writer = BufWriter::new(file);
    content(&mut writer)?;
    writer.flush()
}

/// Makes temporary files with the permissions of any new file, not the owner's alone.
#[cfg(unix)]
fn new_file_builder() -> Builder<'static, 'static> {
    use std::os::unix::fs::PermissionsExt;

    let mut builder = Builder::new();
    builder.permissions(Permissions::from_mode(0o666));
    builder
}

/// Makes temporary files with the permissions of any new file.
#[cfg(not(unix))]
fn new_file_builder() -> Builder<'static, 'static> {
    Builder::new()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names_in(directory: &Path) -> Vec<String> {
        let entries = fs::read_dir(directory).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    fn write_text(path: &Path, text: &str) -> Result<(), OutputError> {
        write_whole(path, |writer| writer.write_all(text.as_bytes()))
    }

    #[test]
    fn a_file_is_made_and_replaced_and_nothing_is_left_beside_it() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("out.txt");
        for text in ["a long first text", "second"] {
            write_text(&path, text).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), text);
            assert_eq!(names_in(directory.path()), ["out.txt"]);
        }
    }

    #[test]
    fn a_failure_leaves_the_old_file_and_names_the_path() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("out.txt");
        write_text(&path, "old").unwrap();
        let error = write_whole(&path, |writer| {
            writer.write_all(b"half of the new")?;
            Err(io::Error::other("no more"))
        })
        .unwrap_err();
        let message = error.to_string();
        assert!(message.contains("out.txt") && message.contains("no more"), "{message}");
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(names_in(directory.path()), ["out.txt"]);
    }

    #[test]
    fn a_directory_and_a_path_below_no_directory_are_errors() {
        let directory = tempfile::tempdir().unwrap();
        assert!(write_text(directory.path(), "text").is_err());
        assert!(write_text(&directory.path().join("missing/out.txt"), "text").is_err());
        assert!(names_in(directory.path()).is_empty());
    }

    #[cfg(unix)]
    mod unix {
        use super::*;
        use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};

        fn mode(path: &Path) -> u32 {
            fs::metadata(path).unwrap().permissions().mode() & 0o777
        }

        #[test]
        fn permissions_are_those_of_a_plain_new_file_or_of_the_old_one() {
            let directory = tempfile::tempdir().unwrap();
            let [path, plain] = ["out.txt", "plain.txt"].map(|name| directory.path().join(name));
            write_text(&path, "text").unwrap();
            fs::write(&plain, "text").unwrap();
            assert_eq!(mode(&path), mode(&plain));

            fs::set_permissions(&path, Permissions::from_mode(0o640)).unwrap();
            write_text(&path, "new").unwrap();
            assert_eq!(mode(&path), 0o640);
        }

        #[test]
        fn links_are_followed_and_kept() {
            let directory = tempfile::tempdir().unwrap();
            let [file, link] = ["file.txt", "link.txt"].map(|name| directory.path().join(name));
            symlink("file.txt", &link).unwrap();
            for text in ["through a link to nothing", "through a link to a file"] {
                fs::remove_file(&file).ok();
                if text.ends_with("file") {
                    fs::write(&file, "old").unwrap();
                }
                write_text(&link, text).unwrap();
                assert!(link.is_symlink());
                assert_eq!(fs::read_to_string(&file).unwrap(), text);
            }
        }

        #[test]
        fn devices_are_written_directly() {
            let null = Path::new("/dev/null");
            write_text(null, "text").unwrap();
            assert!(fs::metadata(null).unwrap().file_type().is_char_device());
            // A device that is always full.
            let full = Path::new("/dev/full");
            assert!(!full.exists() || write_text(full, "text").is_err());
        }
    }
}
