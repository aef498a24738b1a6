//! Files that appear whole or not at all.
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process;

/// Writes a file so that a reader sees the old content or the new, never a part.
///
/// The bytes go to a temporary name in the same folder, are flushed to the disk and then renamed over `path`.
/// A link is followed, so that its target is replaced and the link stays; what is there but is no file (a pipe,
/// `/dev/stdout`) is written to directly, because it cannot be replaced.
///
/// # Errors
/// Whatever the file system says; the temporary file is gone by then and an earlier file at `path` is untouched.
///
/// # Examples
/// ```
/// let path = std::env::temp_dir().join(format!("holdup-{}.txt", std::process::id()));
/// holdup::study::output::write_atomically(&path, b"whole")?;
/// assert_eq!(std::fs::read(&path)?, b"whole");
/// std::fs::remove_file(&path)?;
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write_atomically(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = WholeFile::create(path)?;
    file.write_all(bytes)?;
    file.commit()
}

/// A file that is written piece by piece and appears whole, when it is committed, or not at all.
///
/// # Examples
/// ```
/// use std::io::Write;
/// let path = std::env::temp_dir().join(format!("holdup-whole-{}.txt", std::process::id()));
/// let mut file = holdup::study::output::WholeFile::create(&path)?;
/// file.write_all(b"first, ")?;
/// assert!(!path.exists());
/// file.write_all(b"second")?;
/// file.commit()?;
/// assert_eq!(std::fs::read(&path)?, b"first, second");
/// std::fs::remove_file(&path)?;
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct WholeFile {
    file: File,
    /// Where the bytes go and what they replace; absent where they go to what is no file, directly.
    names: Option<(PathBuf, PathBuf)>,
}

impl WholeFile {
    /// Opens the temporary file that becomes `path`.
    ///
    /// # Errors
    /// Whatever the file system says.
    pub fn create(path: &Path) -> io::Result<Self> {
        let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
        let standing = fs::metadata(&path).ok();
        if standing.as_ref().is_some_and(|there| !there.is_file() && !there.is_dir()) {
            let file = File::options().write(true).open(&path)?;
            return Ok(Self { file, names: None });
        }
        if standing.as_ref().is_some_and(fs::Metadata::is_dir) {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "is a directory"));
        }
        let temporary = temporary_beside(&path)?;
        let file = File::create(&temporary)?;
        let whole = Self { file, names: Some((temporary, path)) };
        if let Some(there) = standing {
            whole.file.set_permissions(there.permissions())?;
        }
        Ok(whole)
    }

    /// Flushes the bytes to the disk and renames the file over its path.
    ///
    /// # Errors
    /// Whatever the file system says; the temporary file is gone by then and an earlier file is untouched.
    pub fn commit(mut self) -> io::Result<()> {
        let Some((temporary, path)) = &self.names else { return self.file.flush() };
        self.file.sync_all()?;
        fs::rename(temporary, path)?;
        self.names = None;
        Ok(())
    }
}

impl Write for WholeFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for WholeFile {
    fn drop(&mut self) {
        if let Some((temporary, _)) = &self.names {
            // Whatever kept the file from being committed is the error to tell.
            let _ = fs::remove_file(temporary);
        }
    }
}

/// The name is hidden and carries the process, so that two runs that write the same file do not meet.
fn temporary_beside(path: &Path) -> io::Result<PathBuf> {
    let Some(name) = path.file_name() else {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "the path names no file"));
    };
    let mut hidden = OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{}.tmp", process::id()));
    Ok(path.with_file_name(hidden))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("holdup-output-{name}-{}", process::id()));
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    fn names(folder: &Path) -> Vec<String> {
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    #[test]
    fn a_second_write_replaces_the_first_and_leaves_nothing_else() {
        let folder = folder("replace");
        let path = folder.join("report.html");
        write_atomically(&path, b"a longer first content").unwrap();
        write_atomically(&path, b"second").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"second");
        assert_eq!(names(&folder), ["report.html"]);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_failed_write_leaves_no_temporary_file() {
        let folder = folder("failed");
        let taken = folder.join("taken");
        fs::create_dir_all(taken.join("inside")).unwrap();
        assert!(write_atomically(&taken, b"a file cannot replace this folder").is_err());
        assert_eq!(names(&folder), ["taken"]);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_folder_that_is_absent_and_a_path_without_a_name_are_errors() {
        assert!(write_atomically(Path::new("/nonexistent-holdup/report.html"), b"").is_err());
        assert!(write_atomically(Path::new("/"), b"").is_err());
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link_and_its_target_is_replaced() {
        let folder = folder("link");
        let (target, link) = (folder.join("target"), folder.join("link"));
        fs::write(&target, b"old").unwrap();
        std::os::unix::fs::symlink(&target, &link).unwrap();
        write_atomically(&link, b"new").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().file_type().is_symlink());
        assert_eq!(fs::read(&target).unwrap(), b"new");
        fs::remove_dir_all(folder).unwrap();
    }
}
