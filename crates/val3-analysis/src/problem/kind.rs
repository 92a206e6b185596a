//! All kinds of faults that the analysis finds.

use smol_str::SmolStr;

use super::{DataSize, EncodingFault, FileRole, ModbusTableFault, NameKind, PageFault};
use crate::cell::UnreadableCellFile;

/// Kind of fault. Types are written as in a program: `num`, `point[]`, `string[""]`, `Slot`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ProblemKind {
    // ---- names ----
    /// No local, parameter, data or built-in item has this name.
    UnknownName {
        /// The name as written.
        name: SmolStr,
        /// Most similar known name.
        near: Option<SmolStr>,
    },
    /// `call` of a program that the application does not have.
    UnknownProgram {
        /// The name as written.
        name: SmolStr,
        /// The most similar program.
        near: Option<SmolStr>,
        /// Kind of item that the name refers to instead.
        is: Option<NameKind>,
    },
    /// An instruction that does not exist in VAL 3.
    UnknownInstruction {
        /// The name as written.
        name: SmolStr,
        /// The most similar instruction.
        near: Option<SmolStr>,
        /// Kind of item that the name refers to instead (`call` is missing, or an index is in round brackets).
        is: Option<NameKind>,
    },
    /// An add-on instruction whose table is missing in the cell.
    MissingAddOn {
        /// The instruction (`$fileOpen`).
        name: SmolStr,
        /// Add-on that provides the instruction, if known.
        add_on: Option<SmolStr>,
        /// Whether the cell has tables of other add-ons.
        lists_others: bool,
        /// Syntax lines of the known forms, if the arguments match none of them.
        other_forms: Vec<SmolStr>,
    },
    /// A library identifier that the project does not declare.
    UnknownLibrary {
        /// The identifier as written.
        alias: SmolStr,
        /// The most similar identifier.
        near: Option<SmolStr>,
    },
    /// A type that is neither built in nor in the project's `<Types>`.
    UnknownType {
        /// The type as written.
        name: SmolStr,
        /// The most similar type.
        near: Option<SmolStr>,
    },
    /// A field that the type does not have.
    UnknownField {
        /// The type on the left of the dot.
        ty: SmolStr,
        /// The field as written.
        field: SmolStr,
        /// The most similar field.
        near: Option<SmolStr>,
    },
    /// The same name declared twice in one scope.
    DuplicateName {
        /// The name.
        name: SmolStr,
        /// Kind of declaration.
        what: NameKind,
    },
    /// A name that is longer than the VAL 3 version allows.
    NameTooLong {
        /// The name.
        name: SmolStr,
        /// The limit in characters.
        limit: usize,
    },
    /// A name with characters that VAL 3 does not allow.
    InvalidName {
        /// The name.
        name: SmolStr,
    },
    /// A keyword or the name of a built-in type or instruction used as a name.
    ReservedName {
        /// The name.
        name: SmolStr,
    },
    /// A program, library identifier or type used as a value.
    NotAValue {
        /// The name.
        name: SmolStr,
        /// Kind of item that the name refers to.
        is: NameKind,
    },
    // ---- types ----
    /// The operator is not defined for these types.
    OperatorType {
        /// The operator as written.
        op: SmolStr,
        /// Type of the left operand; `None` for a unary operator.
        left: Option<SmolStr>,
        /// Type of the right operand.
        right: SmolStr,
    },
    /// The type of the value does not match the variable.
    AssignmentType {
        /// Type of the variable.
        target: SmolStr,
        /// Type of the value.
        value: SmolStr,
    },
    /// The left side of `=` is no variable.
    NotAssignable,
    /// The type of the argument is not the parameter's.
    ArgumentType {
        /// The callee.
        callee: SmolStr,
        /// Name of the parameter.
        parameter: SmolStr,
        /// Types that the forms of the callee accept.
        expected: Vec<SmolStr>,
        /// Type of the argument.
        found: SmolStr,
    },
    /// Too many or too few arguments.
    ArgumentCount {
        /// The callee.
        callee: SmolStr,
        /// Accepted counts in ascending order.
        expected: Vec<usize>,
        /// Actual count.
        found: usize,
        /// Syntax lines of the callee.
        forms: Vec<SmolStr>,
    },
    /// A constant or computed value is passed by reference (2.6.2).
    VariableExpected {
        /// The callee.
        callee: SmolStr,
        /// Name of the parameter.
        parameter: SmolStr,
    },
    /// Another kind of container is required by a parameter by reference (2.6.3).
    ContainerMismatch {
        /// The callee.
        callee: SmolStr,
        /// Name of the parameter.
        parameter: SmolStr,
        /// Type of the parameter with its container.
        expected: SmolStr,
        /// Type of the argument with its container.
        found: SmolStr,
    },
    /// The condition of `if`, `while`, `until`, `wait` … is no `bool`.
    ConditionType {
        /// The keyword.
        keyword: SmolStr,
        /// Actual type.
        found: SmolStr,
    },
    /// An array of several dimensions or a collection used without index or key.
    IndexMissing {
        /// The variable.
        name: SmolStr,
        /// Type of the variable.
        ty: SmolStr,
    },
    /// An index that is not allowed: after an element, or after a container that is passed entirely.
    IndexNotAllowed {
        /// The variable.
        name: SmolStr,
        /// Type of the variable.
        ty: SmolStr,
        /// Callee that requires the whole container.
        callee: Option<SmolStr>,
    },
    /// The number of indexes differs from the number of dimensions.
    IndexCount {
        /// The variable.
        name: SmolStr,
        /// Number of dimensions.
        expected: usize,
        /// Number of indexes.
        found: usize,
    },
    /// An array index that is no `num`, or a collection key that is no `string`.
    IndexType {
        /// The variable.
        name: SmolStr,
        /// `num` or `string`.
        expected: SmolStr,
        /// Actual type.
        found: SmolStr,
    },
    /// A constant index that is always outside of the array.
    IndexOutOfBounds {
        /// The variable.
        name: SmolStr,
        /// Rounded index.
        index: i64,
        /// Size of the dimension.
        size: usize,
    },
    /// The type of a `case` value differs from the type of the `switch`.
    CaseType {
        /// Type of the `switch`.
        expected: SmolStr,
        /// Type of the `case`.
        found: SmolStr,
    },
    /// `switch` over a type that `==` does not support.
    SwitchType {
        /// Actual type.
        found: SmolStr,
    },
    /// A `{…}` with more values than the type has fields.
    LiteralFieldCount {
        /// The type.
        ty: SmolStr,
        /// Number of fields.
        expected: usize,
        /// Number of values.
        found: usize,
    },
    /// A value in `{…}` whose type differs from the field's.
    LiteralFieldType {
        /// Type of the `{…}`.
        ty: SmolStr,
        /// The field.
        field: SmolStr,
        /// Type of the field.
        expected: SmolStr,
        /// Actual type.
        found: SmolStr,
    },
    /// A `{…}` where no structure is expected, so that it has no type.
    LiteralWithoutType {
        /// Expected type, if known.
        expected: Option<SmolStr>,
    },
    /// The counter of `for` is no `num` variable.
    ForCounter {
        /// Actual type.
        found: SmolStr,
    },
    /// A bound or the step of `for` is no `num`.
    ForBound {
        /// `=`, `to` or `step`.
        keyword: SmolStr,
        /// Actual type.
        found: SmolStr,
    },
    /// The line computes a value without using it.
    NoEffect,
    /// An instruction without a result is used as a value.
    NoValue {
        /// The callee.
        callee: SmolStr,
    },
    /// A position for another kind of arm (`jointRs` on a six-axis arm).
    WrongArm {
        /// Actual type.
        found: SmolStr,
        /// Expected type.
        expected: SmolStr,
    },
    /// A string literal of more than 128 bytes; contains its length in bytes of UTF-8.
    StringTooLong(usize),
    // ---- project and data ----
    /// A file in the project file does not exist on the disk.
    FileMissing {
        /// Role of the file.
        what: FileRole,
        /// The path as written.
        path: SmolStr,
    },
    /// A file outside of the project's folder, or a library outside of the cell, which is not read; role and path.
    FileOutside(FileRole, SmolStr),
    /// A file that exists but cannot be read.
    FileUnreadable {
        /// Path as written in the project file; only the file name if no project lists the file.
        path: SmolStr,
        /// Error message of the system.
        reason: SmolStr,
    },
    /// A file of the cell that exists but cannot be read.
    CellFileUnreadable(UnreadableCellFile),
    /// A fault of the tables of the cell's Modbus server.
    ModbusTable(Box<ModbusTableFault>),
    /// A path with backslashes.
    PathSeparator {
        /// The path as written.
        path: SmolStr,
    },
    /// The path of a library or type has a root without a known folder.
    UnresolvedPath {
        /// Role of the file.
        what: FileRole,
        /// The path as written.
        path: SmolStr,
        /// Root name, for example `Disk` or `USB0`.
        root: SmolStr,
        /// Most similar root.
        near: Option<SmolStr>,
    },
    /// The text is not in the declared encoding, or was read in another encoding.
    Encoding(EncodingFault),
    /// A file listed twice in the project file, or a library identifier or type declared twice.
    DuplicateEntry {
        /// Role of the item.
        what: FileRole,
        /// Path or name.
        name: SmolStr,
    },
    /// The root element does not match the kind of file.
    WrongRoot {
        /// Expected kind of file.
        expected: FileRole,
        /// Actual root element.
        found: SmolStr,
    },
    /// A required attribute is missing.
    MissingAttribute {
        /// The element.
        element: SmolStr,
        /// The attribute.
        attribute: SmolStr,
        /// Value that is assumed instead, if any.
        default: Option<SmolStr>,
        /// Unknown attribute that is probably a misspelling of it.
        written: Option<SmolStr>,
    },
    /// An attribute that the element does not support.
    UnknownAttribute {
        /// The element.
        element: SmolStr,
        /// The attribute.
        attribute: SmolStr,
        /// Most similar attribute that the element does not have.
        near: Option<SmolStr>,
    },
    /// A required element is missing.
    MissingElement {
        /// Parent element.
        parent: SmolStr,
        /// Missing element.
        element: SmolStr,
    },
    /// The root, or an element with its own namespace, is not in the namespace of this kind of file.
    Namespace {
        /// The element.
        element: SmolStr,
        /// Actual namespace.
        found: SmolStr,
        /// Expected namespace.
        expected: SmolStr,
    },
    /// An attribute with an invalid value.
    InvalidAttribute {
        /// The element.
        element: SmolStr,
        /// The attribute.
        attribute: SmolStr,
        /// Actual value.
        value: SmolStr,
        /// Valid values.
        expected: SmolStr,
    },
    /// An element that must not appear in its parent.
    UnexpectedElement {
        /// The element.
        name: SmolStr,
        /// Parent element.
        parent: SmolStr,
    },
    /// The program name in a `.pgx` differs from the file name.
    ProgramNameMismatch {
        /// Program name.
        program: SmolStr,
        /// File name without `.pgx`.
        file: SmolStr,
    },
    /// An invalid initial value.
    InvalidValue {
        /// The type.
        ty: SmolStr,
        /// The attribute.
        attribute: SmolStr,
        /// Actual text.
        value: SmolStr,
        /// Valid values.
        expected: SmolStr,
    },
    /// An attribute of `<Value>` that the type does not support.
    UnknownValueAttribute {
        /// The type.
        ty: SmolStr,
        /// The attribute.
        attribute: SmolStr,
        /// The most similar attribute.
        near: Option<SmolStr>,
    },
    /// A key outside the size of the array.
    KeyOutOfRange {
        /// The key.
        key: SmolStr,
        /// The size.
        size: SmolStr,
    },
    /// A repeated key.
    DuplicateKey {
        /// The key.
        key: SmolStr,
    },
    /// A key that is no index of the array.
    InvalidKey {
        /// The key.
        key: SmolStr,
        /// Dimensions of the array.
        dims: usize,
    },
    /// A `<Field>` that does not exist in the user type.
    UnknownUserField {
        /// The type.
        ty: SmolStr,
        /// The field.
        field: SmolStr,
        /// The most similar field.
        near: Option<SmolStr>,
    },
    /// A `<Field>` whose type or container differs from the user type's.
    UserFieldType {
        /// The user type.
        ty: SmolStr,
        /// The field.
        field: SmolStr,
        /// Declaration in the user type.
        expected: SmolStr,
        /// Actual declaration.
        found: SmolStr,
    },
    /// A `size` that is no list of integers with one to three entries.
    InvalidSize {
        /// Actual text.
        size: SmolStr,
    },
    /// A variable that, alone or with all preceding variables of the file, needs more memory than a controller has.
    DataTooLarge(DataSize),
    /// A father (reference frame or base tool) that does not exist.
    FatherMissing {
        /// Father reference as written.
        father: SmolStr,
        /// Most similar frame or tool.
        near: Option<SmolStr>,
    },
    /// A father of the wrong type.
    FatherKind {
        /// Father reference as written.
        father: SmolStr,
        /// `frame` or `tool`.
        expected: SmolStr,
        /// Actual type.
        found: SmolStr,
    },
    /// Data called `world` or `flange` with another type, which is named as a father (related: the references).
    FatherHidden {
        /// The name.
        name: SmolStr,
        /// `frame` or `tool`.
        expected: SmolStr,
        /// Actual type.
        found: SmolStr,
        /// Number of values with this father.
        uses: usize,
    },
    /// Frames or tools whose fathers form a cycle.
    FatherCircle {
        /// Names in order; the first name is repeated at the end.
        chain: Vec<SmolStr>,
    },
    /// A father in a library.
    FatherInLibrary {
        /// Father reference as written.
        father: SmolStr,
    },
    /// A father reference with an index outside of the array.
    FatherIndex {
        /// Father reference as written.
        father: SmolStr,
        /// The size of the array.
        size: SmolStr,
    },
    /// A fault of a user page of the application.
    Page(PageFault),
    /// An input or output that is missing in the cell's configuration.
    IoLinkUnknown {
        /// The link as written.
        link: SmolStr,
        /// The most similar link.
        near: Option<SmolStr>,
    },
    /// A link whose input or output has a different type.
    IoLinkKind {
        /// The link as written.
        link: SmolStr,
        /// Expected type: `dio`, `aio` or `sio`.
        expected: SmolStr,
        /// Actual type.
        found: SmolStr,
    },
    /// Libraries or types that use each other in a cycle (6.6).
    LibraryCircle {
        /// Projects in order; the first project is repeated at the end.
        chain: Vec<SmolStr>,
    },
    // ---- library interfaces ----
    /// The interface of the identifier has no such item.
    LibraryItemUnknown {
        /// The identifier.
        alias: SmolStr,
        /// The item.
        item: SmolStr,
        /// Kind of item as used.
        what: NameKind,
        /// The most similar public item.
        near: Option<SmolStr>,
    },
    /// The library's project file omits all used items (related: its list and the uses).
    LibraryLeftOut {
        /// The identifier.
        alias: SmolStr,
        /// Missing items, sorted; at least one.
        missing: Vec<SmolStr>,
        /// Unlisted files in the library's folder.
        unlisted: Vec<SmolStr>,
        /// Number of uses.
        uses: usize,
    },
    /// The item exists but is private.
    LibraryItemPrivate {
        /// The identifier.
        alias: SmolStr,
        /// The item.
        item: SmolStr,
        /// The kind of item.
        what: NameKind,
    },
    /// The identifier has `autoload="false"`, and no program loads it.
    LibraryNeverLoaded {
        /// The identifier.
        alias: SmolStr,
    },
    /// `libLoad` with a path, as written, at which no library exists.
    LibLoadPath(SmolStr),
    /// A library that may be loaded under the identifier does not have all used items of the interface.
    ImplementationMissing {
        /// The identifier.
        alias: SmolStr,
        /// Project name of the library.
        library: SmolStr,
        /// Missing items, sorted by name; at least one.
        items: Vec<(NameKind, SmolStr)>,
    },
    /// The item exists in the library but is private.
    ImplementationPrivate {
        /// The identifier.
        alias: SmolStr,
        /// Project name of the library.
        library: SmolStr,
        /// The item.
        item: SmolStr,
        /// The kind of item.
        what: NameKind,
    },
    /// The item exists in the library with another type, container, parameter or passing mode.
    ImplementationDifferent {
        /// The identifier.
        alias: SmolStr,
        /// Project name of the library.
        library: SmolStr,
        /// The item.
        item: SmolStr,
        /// The kind of item.
        what: NameKind,
        /// Syntax line of the interface.
        expected: SmolStr,
        /// Syntax line of the library.
        found: SmolStr,
    },
}
