//! The file that a planner wrote: an ordinary one of bounded size.

use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

use rustix::fs::{Mode, OFlags};

/// The most bytes that a planner may write.
pub(super) const MOST_BYTES: u64 = 64_000_000;

/// Why there is no text to judge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum NoText {
    /// There is no file, or it is empty.
    Nothing,
    /// There is something that is not read, with a phrase about it.
    Unreadable(String),
}

/// Reads what a planner wrote. A link is not followed and a pipe is not waited for: what it
/// leaves there is none of our business.
pub(super) fn read(path: &Path) -> Result<String, NoText> {
    let flags = OFlags::RDONLY | OFlags::NOFOLLOW | OFlags::NONBLOCK | OFlags::CLOEXEC;
    let file = match rustix::fs::open(path, flags, Mode::empty()) {
        Ok(file) => File::from(file),
        Err(rustix::io::Errno::NOENT) => return Err(NoText::Nothing),
        Err(rustix::io::Errno::LOOP) => return Err(unreadable("a link instead of a file")),
        Err(error) => {
            return Err(NoText::Unreadable(format!(
                "a file that cannot be read ({error})"
            )));
        }
    };
    let is_file = file.metadata().is_ok_and(|metadata| metadata.is_file());
    if !is_file {
        return Err(unreadable("something else than an ordinary file"));
    }
    let mut bytes = Vec::new();
    let read = file.take(MOST_BYTES + 1).read_to_end(&mut bytes);
    if let Err(error) = read {
        return Err(NoText::Unreadable(format!(
            "a file that cannot be read ({error})"
        )));
    }
    if bytes.len() as u64 > MOST_BYTES {
        return Err(NoText::Unreadable(too_long()));
    }
    if bytes.trim_ascii().is_empty() {
        return Err(NoText::Nothing);
    }
    String::from_utf8(bytes).map_err(|_| unreadable("letters that are not UTF-8"))
}

/// A phrase for more than is read.
pub(super) fn too_long() -> String {
    format!("more than {} MB", MOST_BYTES / 1_000_000)
}

/// Whether a planner has written more than is read.
pub(super) fn is_too_long(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|metadata| metadata.len() > MOST_BYTES)
}

fn unreadable(what: &str) -> NoText {
    NoText::Unreadable(what.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_an_ordinary_file_of_bounded_size_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let why = |name: &str| match read(&at(name)) {
            Err(NoText::Unreadable(why)) => why,
            other => panic!("{other:?}"),
        };
        assert_eq!(read(&at("none")), Err(NoText::Nothing));
        fs::write(at("blank"), " \n").unwrap();
        assert_eq!(read(&at("blank")), Err(NoText::Nothing));
        fs::write(at("plan"), "Agent 0: (0,0)->\n").unwrap();
        assert_eq!(read(&at("plan")).unwrap(), "Agent 0: (0,0)->\n");
        std::os::unix::fs::symlink(at("plan"), at("link")).unwrap();
        assert!(why("link").contains("link"));
        let made = std::process::Command::new("mkfifo")
            .arg(at("pipe"))
            .status();
        assert!(made.unwrap().success());
        assert!(why("pipe").contains("ordinary"));
        fs::create_dir(at("folder")).unwrap();
        assert!(why("folder").contains("ordinary"));
        File::create(at("long"))
            .unwrap()
            .set_len(MOST_BYTES + 1)
            .unwrap();
        assert_eq!(why("long"), "more than 64 MB");
        assert!(is_too_long(&at("long")) && !is_too_long(&at("plan")));
        fs::write(at("bytes"), [b'A', 0xff]).unwrap();
        assert!(why("bytes").contains("UTF-8"));
    }
}
