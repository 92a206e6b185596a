//! Size limit for the programs and data of a workspace.

use camino::{Utf8Path, Utf8PathBuf};

/// Remaining size of a workspace in bytes.
#[derive(Debug)]
pub(super) struct Budget {
    limit: u64,
    left: u64,
    /// Path of the first file that exceeded the limit.
    exceeded_at: Option<Utf8PathBuf>,
}

impl Budget {
    /// Creates a budget of `limit` bytes.
    pub(super) fn new(limit: u64) -> Self {
        Self { limit, left: limit, exceeded_at: None }
    }

    /// Reserves the size of a file. Returns whether it fits.
    pub(super) fn reserve(&mut self, path: &Utf8Path, bytes: u64) -> bool {
        match self.left.checked_sub(bytes) {
            Some(left) => {
                self.left = left;
                true
            }
            None => {
                self.exceeded_at.get_or_insert_with(|| path.to_owned());
                false
            }
        }
    }

    /// Returns the first file that was not read and the reason; `None` if all files were read.
    pub(super) fn excess(&self) -> Option<(Utf8PathBuf, String)> {
        Some((self.exceeded_at.clone()?, self.reason()))
    }

    /// Returns the reason why a file is not read.
    pub(super) fn reason(&self) -> String {
        format!(
            "the programs and data around it have more than {} bytes; name a smaller folder, or raise the limit with \
             --max-workspace-size",
            self.limit
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_file_beyond_the_limit_is_named() {
        let mut budget = Budget::new(10);
        assert!(budget.reserve("/a".into(), 6));
        assert_eq!(budget.excess(), None);
        assert!(!budget.reserve("/b".into(), 5));
        assert!(budget.reserve("/c".into(), 4), "a smaller file still fits");
        assert!(!budget.reserve("/d".into(), 1));
        assert_eq!(budget.excess().unwrap().0, "/b");
    }
}
