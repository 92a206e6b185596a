//! Two versions of files.

use val3_diff::FileTree;

/// Both versions, and their names.
pub(super) struct ComparedVersions {
    pub(super) trees: [FileTree; 2],
    pub(super) names: [String; 2],
}
