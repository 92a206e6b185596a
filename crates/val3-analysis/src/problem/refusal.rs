//! Faults with which the controller's compiler rejects an application.

use super::{FileRole, ProblemKind};

impl ProblemKind {
    /// Whether the controller's compiler rejects an application or library with this fault.
    ///
    /// This is a property of the language; rule levels, settings and suppressions have no influence. Faults that the
    /// controller reports at run time do not count: an index outside the array (error 20), and a library that is
    /// missing or differs from its interface (error 80 and the codes of `libLoad`). A syntax error always counts.
    #[must_use]
    pub fn is_refused(&self) -> bool {
        match self {
            Self::UnknownName { .. }
            | Self::UnknownProgram { .. }
            | Self::UnknownInstruction { .. }
            | Self::MissingAddOn { .. }
            | Self::UnknownLibrary { .. }
            | Self::UnknownType { .. }
            | Self::UnknownField { .. }
            | Self::DuplicateName { .. }
            | Self::InvalidName { .. }
            | Self::ReservedName { .. }
            | Self::NotAValue { .. }
            | Self::OperatorType { .. }
            | Self::AssignmentType { .. }
            | Self::NotAssignable
            | Self::ArgumentType { .. }
            | Self::ArgumentCount { .. }
            | Self::VariableExpected { .. }
            | Self::ContainerMismatch { .. }
            | Self::ConditionType { .. }
            | Self::IndexMissing { .. }
            | Self::IndexNotAllowed { .. }
            | Self::IndexCount { .. }
            | Self::IndexType { .. }
            | Self::CaseType { .. }
            | Self::SwitchType { .. }
            | Self::LiteralFieldCount { .. }
            | Self::LiteralFieldType { .. }
            | Self::LiteralWithoutType { .. }
            | Self::ForCounter { .. }
            | Self::ForBound { .. }
            | Self::NoEffect
            | Self::NoValue { .. }
            | Self::WrongArm { .. }
            | Self::StringTooLong(_)
            | Self::FileUnreadable { .. }
            | Self::DuplicateEntry { .. }
            | Self::WrongRoot { .. }
            | Self::MissingElement { .. }
            | Self::Namespace { .. }
            | Self::InvalidAttribute { .. }
            | Self::InvalidValue { .. }
            | Self::KeyOutOfRange { .. }
            | Self::DuplicateKey { .. }
            | Self::InvalidKey { .. }
            | Self::UserFieldType { .. }
            | Self::InvalidSize { .. }
            | Self::DataTooLarge(_)
            | Self::FatherMissing { .. }
            | Self::FatherKind { .. }
            | Self::FatherCircle { .. }
            | Self::FatherInLibrary { .. }
            | Self::FatherHidden { .. }
            | Self::FatherIndex { .. }
            | Self::IoLinkKind { .. }
            | Self::LibraryCircle { .. }
            | Self::LibraryItemUnknown { .. }
            | Self::LibraryItemPrivate { .. }
            | Self::LibraryLeftOut { .. } => true,
            Self::MissingAttribute { default, .. } => default.is_none(),
            // Items of a missing library or user type are reported only when a line uses them.
            Self::FileMissing { what, .. } | Self::FileOutside(what, _) => {
                !matches!(what, FileRole::Library | FileRole::Type)
            }
            // Controllers load these. A CS9 accepts long names regardless of the version.
            Self::NameTooLong { .. }
            | Self::Encoding(_)
            | Self::UnexpectedElement { .. }
            | Self::ProgramNameMismatch { .. }
            | Self::UnknownAttribute { .. }
            | Self::UnknownValueAttribute { .. }
            | Self::PathSeparator { .. }
            | Self::UnresolvedPath { .. }
            | Self::UnknownUserField { .. }
            | Self::Page(_)
            | Self::IoLinkUnknown { .. } => false,
            // A fault of the cell: the catalogue also contains the add-on instructions.
            Self::CellFileUnreadable(_) | Self::ModbusTable(_) => false,
            // A task that executes such a line gets a run-time error or a return code.
            Self::IndexOutOfBounds { .. }
            | Self::LibraryNeverLoaded { .. }
            | Self::LibLoadPath(_)
            | Self::ImplementationMissing { .. }
            | Self::ImplementationPrivate { .. }
            | Self::ImplementationDifferent { .. } => false,
        }
    }
}
