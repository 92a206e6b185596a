//! Every kind of fault that the analysis finds.

use smol_str::SmolStr;

use super::{DataSize, EncodingFault, FileRole, NameKind, PageFault};

/// The kinds of faults. Types are given as a programmer would write them: `num`, `point[]`, `string[""]`, `Slot`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ProblemKind {
    // ---- names ----
    /// No local, parameter, data or built-in name is called so.
    UnknownName {
        /// The name as written.
        name: SmolStr,
        /// The most similar known name.
        near: Option<SmolStr>,
    },
    /// `call` of a program that the application does not have.
    UnknownProgram {
        /// The name as written.
        name: SmolStr,
        /// The most similar program.
        near: Option<SmolStr>,
        /// It names an instruction or a variable instead.
        is: Option<NameKind>,
    },
    /// An instruction that VAL 3 does not have.
    UnknownInstruction {
        /// The name as written.
        name: SmolStr,
        /// The most similar instruction.
        near: Option<SmolStr>,
        /// It names a program or a variable instead (`call` is missing, or an index in round brackets).
        is: Option<NameKind>,
    },
    /// An instruction of an add-on whose table the cell does not have.
    MissingAddOn {
        /// The instruction (`$fileOpen`).
        name: SmolStr,
        /// The add-on that has it, where known.
        add_on: Option<SmolStr>,
        /// Whether the cell has tables of other add-ons.
        lists_others: bool,
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
        /// The kind of declaration.
        what: NameKind,
    },
    /// A name longer than the version allows.
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
    /// A program, library identifier or type used where a value belongs.
    NotAValue {
        /// The name.
        name: SmolStr,
        /// The kind of item that it names.
        is: NameKind,
    },
    // ---- types ----
    /// The operator is not defined for these types.
    OperatorType {
        /// The operator as written.
        op: SmolStr,
        /// Type on the left; `None` for a unary operator.
        left: Option<SmolStr>,
        /// Type on the right.
        right: SmolStr,
    },
    /// The value does not fit the variable.
    AssignmentType {
        /// Type of the variable.
        target: SmolStr,
        /// Type of the value.
        value: SmolStr,
    },
    /// The left side of `=` is no variable.
    NotAssignable,
    /// The argument's type is not the parameter's.
    ArgumentType {
        /// The callee.
        callee: SmolStr,
        /// Name of the parameter.
        parameter: SmolStr,
        /// The types that the forms of the callee take here.
        expected: Vec<SmolStr>,
        /// Type of the argument.
        found: SmolStr,
    },
    /// Too many or too few arguments.
    ArgumentCount {
        /// The callee.
        callee: SmolStr,
        /// The counts that are possible, in ascending order.
        expected: Vec<usize>,
        /// The count found.
        found: usize,
        /// The syntax lines of the callee.
        forms: Vec<SmolStr>,
    },
    /// A parameter by reference got a constant or the result of an expression (2.6.2).
    VariableExpected {
        /// The callee.
        callee: SmolStr,
        /// Name of the parameter.
        parameter: SmolStr,
    },
    /// A parameter by reference to a container got another container (2.6.3).
    ContainerMismatch {
        /// The callee.
        callee: SmolStr,
        /// Name of the parameter.
        parameter: SmolStr,
        /// The container the parameter takes, as type text.
        expected: SmolStr,
        /// The argument's, as type text.
        found: SmolStr,
    },
    /// `if`, `while`, `until`, `wait` … without a bool.
    ConditionType {
        /// The keyword.
        keyword: SmolStr,
        /// Type found.
        found: SmolStr,
    },
    /// An array of several dimensions or a collection used without its index or key.
    IndexMissing {
        /// The variable.
        name: SmolStr,
        /// Its type.
        ty: SmolStr,
    },
    /// An index where none is allowed: after an element, or after a container that is passed as a whole.
    IndexNotAllowed {
        /// The variable.
        name: SmolStr,
        /// Its type.
        ty: SmolStr,
        /// The callee that wants the whole container.
        callee: Option<SmolStr>,
    },
    /// The number of indexes is not the number of dimensions.
    IndexCount {
        /// The variable.
        name: SmolStr,
        /// Dimensions.
        expected: usize,
        /// Indexes found.
        found: usize,
    },
    /// An array's index that is no num, or a collection's key that is no string.
    IndexType {
        /// The variable.
        name: SmolStr,
        /// `num` or `string`.
        expected: SmolStr,
        /// Type found.
        found: SmolStr,
    },
    /// A constant index that the array can never have.
    IndexOutOfBounds {
        /// The variable.
        name: SmolStr,
        /// The index, rounded.
        index: i64,
        /// The size of that dimension.
        size: usize,
    },
    /// The value of a `case` is of another type than the `switch`.
    CaseType {
        /// Type of the `switch`.
        expected: SmolStr,
        /// Type of the `case`.
        found: SmolStr,
    },
    /// `switch` over a type that `==` does not compare.
    SwitchType {
        /// Type found.
        found: SmolStr,
    },
    /// More fields between braces than the type has.
    LiteralFieldCount {
        /// The type.
        ty: SmolStr,
        /// Its fields.
        expected: usize,
        /// Values found.
        found: usize,
    },
    /// A value between braces of another type than the field.
    LiteralFieldType {
        /// The type between braces.
        ty: SmolStr,
        /// The field.
        field: SmolStr,
        /// The field's type.
        expected: SmolStr,
        /// Type found.
        found: SmolStr,
    },
    /// Braces where no structure is expected, so that they have no type.
    LiteralWithoutType {
        /// The type expected here, if it is known.
        expected: Option<SmolStr>,
    },
    /// The counter of `for` is no num variable.
    ForCounter {
        /// Type found.
        found: SmolStr,
    },
    /// A bound or the step of `for` is no num.
    ForBound {
        /// `=`, `to` or `step`.
        keyword: SmolStr,
        /// Type found.
        found: SmolStr,
    },
    /// The line computes a value and does nothing with it.
    NoEffect,
    /// An instruction that yields no value, used as a value.
    NoValue {
        /// The callee.
        callee: SmolStr,
    },
    /// A position of another arm (`jointRs` where the arm has six axes).
    WrongArm {
        /// The type found.
        found: SmolStr,
        /// The type expected.
        expected: SmolStr,
    },
    /// A string literal of more than 128 bytes; with its bytes in UTF-8.
    StringTooLong(usize),
    // ---- project and data ----
    /// A file named in the project is not on the disk.
    FileMissing {
        /// The expected spelling.
        what: FileRole,
        /// The path as written.
        path: SmolStr,
    },
    /// A file outside of the folder of the project, or a library outside of the cell; its path. It is not read.
    FileOutside(FileRole, SmolStr),
    /// A file exists but cannot be read.
    FileUnreadable {
        /// The path as the project writes it; the name of a file that no project lists.
        path: SmolStr,
        /// The reason, as the system words it.
        reason: SmolStr,
    },
    /// A file of the cell exists but cannot be read.
    CellFileUnreadable {
        /// The path from `usr`.
        path: SmolStr,
        /// The reason, as the system or the reader of tables words it.
        reason: SmolStr,
    },
    /// A path with backslashes.
    PathSeparator {
        /// The path as written.
        path: SmolStr,
    },
    /// The path of a library or type whose root has no known folder here.
    UnresolvedPath {
        /// The kind of file expected there.
        what: FileRole,
        /// The path as written.
        path: SmolStr,
        /// The root: `Disk`, `USB0`.
        root: SmolStr,
        /// The root that was probably meant.
        near: Option<SmolStr>,
    },
    /// The text is not in the declared encoding, or was read in another one.
    Encoding(EncodingFault),
    /// A file named twice in the project, or a library identifier or type declared twice.
    DuplicateEntry {
        /// The kind of item.
        what: FileRole,
        /// Path or name.
        name: SmolStr,
    },
    /// The root element is not that of the file kind.
    WrongRoot {
        /// The expected kind of file.
        expected: FileRole,
        /// The root element found.
        found: SmolStr,
    },
    /// A required attribute is missing.
    MissingAttribute {
        /// The element.
        element: SmolStr,
        /// The attribute.
        attribute: SmolStr,
        /// The value that is assumed instead, where there is one.
        default: Option<SmolStr>,
        /// The unknown attribute that was probably meant to be it.
        written: Option<SmolStr>,
    },
    /// An attribute that the element does not have.
    UnknownAttribute {
        /// The element.
        element: SmolStr,
        /// The attribute.
        attribute: SmolStr,
        /// The most similar attribute that is not there.
        near: Option<SmolStr>,
    },
    /// A required element is missing.
    MissingElement {
        /// The element around it.
        parent: SmolStr,
        /// The element that is missing.
        element: SmolStr,
    },
    /// The root, or a part with a namespace of its own, is in another namespace than that of its kind of file.
    Namespace {
        /// The element.
        element: SmolStr,
        /// The namespace found.
        found: SmolStr,
        /// The namespace of this element.
        expected: SmolStr,
    },
    /// An attribute with a value that it cannot have.
    InvalidAttribute {
        /// The element.
        element: SmolStr,
        /// The attribute.
        attribute: SmolStr,
        /// The value found.
        value: SmolStr,
        /// The possible values.
        expected: SmolStr,
    },
    /// An element in a place where it does not belong.
    UnexpectedElement {
        /// The element.
        name: SmolStr,
        /// The element around it.
        parent: SmolStr,
    },
    /// The program in a `.pgx` has another name than the file.
    ProgramNameMismatch {
        /// The program's name.
        program: SmolStr,
        /// The file's name without `.pgx`.
        file: SmolStr,
    },
    /// An initial value that the type cannot have.
    InvalidValue {
        /// The type.
        ty: SmolStr,
        /// The attribute.
        attribute: SmolStr,
        /// The text found.
        value: SmolStr,
        /// The possible values.
        expected: SmolStr,
    },
    /// An attribute of `<Value>` that the type does not have.
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
    /// A key twice.
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
    /// A `<Field>` that the user type does not have.
    UnknownUserField {
        /// The type.
        ty: SmolStr,
        /// The field.
        field: SmolStr,
        /// The most similar field.
        near: Option<SmolStr>,
    },
    /// A `<Field>` whose type or container is not that of the user type.
    UserFieldType {
        /// The user type.
        ty: SmolStr,
        /// The field.
        field: SmolStr,
        /// The declaration of the type.
        expected: SmolStr,
        /// The declaration found here.
        found: SmolStr,
    },
    /// A `size` that is no list of one to three whole numbers.
    InvalidSize {
        /// The text found.
        size: SmolStr,
    },
    /// A variable that needs more memory than a controller has, alone or with those before it in the file.
    DataTooLarge(DataSize),
    /// A father (reference frame or base tool) that does not exist.
    FatherMissing {
        /// The reference as written.
        father: SmolStr,
        /// The most similar frame or tool.
        near: Option<SmolStr>,
    },
    /// A father of the wrong kind.
    FatherKind {
        /// The reference as written.
        father: SmolStr,
        /// `frame` or `tool`.
        expected: SmolStr,
        /// Type found.
        found: SmolStr,
    },
    /// Data that is called `world` or `flange`, is of another type, and is named as a father (related: where).
    FatherHidden {
        /// The name.
        name: SmolStr,
        /// `frame` or `tool`.
        expected: SmolStr,
        /// Type found.
        found: SmolStr,
        /// How many values name it.
        uses: usize,
    },
    /// Frames or tools that hang on each other in a circle.
    FatherCircle {
        /// The names in order, the first again at the end.
        chain: Vec<SmolStr>,
    },
    /// A father that lives in a library.
    FatherInLibrary {
        /// The reference as written.
        father: SmolStr,
    },
    /// A father's index outside its array.
    FatherIndex {
        /// The reference as written.
        father: SmolStr,
        /// The size of the array.
        size: SmolStr,
    },
    /// A fault of a user page of the application.
    Page(PageFault),
    /// An input or output that the cell's configuration does not have.
    IoLinkUnknown {
        /// The link as written.
        link: SmolStr,
        /// The most similar link.
        near: Option<SmolStr>,
    },
    /// A link to an input or output of another kind.
    IoLinkKind {
        /// The link as written.
        link: SmolStr,
        /// `dio`, `aio` or `sio`.
        expected: SmolStr,
        /// The kind found.
        found: SmolStr,
    },
    /// Libraries or types that use each other in a circle (6.6).
    LibraryCircle {
        /// The projects in order, the first again at the end.
        chain: Vec<SmolStr>,
    },
    // ---- library interfaces ----
    /// The interface of the identifier has no such item.
    LibraryItemUnknown {
        /// The identifier.
        alias: SmolStr,
        /// The item.
        item: SmolStr,
        /// The kind that it was used as.
        what: NameKind,
        /// The most similar public item.
        near: Option<SmolStr>,
    },
    /// The project of the identifier lists nothing of what is used of it (related: its list, and where it is used).
    LibraryLeftOut {
        /// The identifier.
        alias: SmolStr,
        /// The missing items, sorted; at least one.
        missing: Vec<SmolStr>,
        /// The files in the library's folder that its project does not list.
        unlisted: Vec<SmolStr>,
        /// How many times they are used.
        uses: usize,
    },
    /// The item exists and is private.
    LibraryItemPrivate {
        /// The identifier.
        alias: SmolStr,
        /// The item.
        item: SmolStr,
        /// The kind of item.
        what: NameKind,
    },
    /// The identifier has `autoload="false"` and nothing loads it.
    LibraryNeverLoaded {
        /// The identifier.
        alias: SmolStr,
    },
    /// `libLoad` of a path without a library.
    LibLoadPath {
        /// The path as written.
        path: SmolStr,
    },
    /// A library that can be loaded under the identifier lacks an item of the interface.
    ImplementationMissing {
        /// The identifier.
        alias: SmolStr,
        /// The library's project.
        library: SmolStr,
        /// The missing items, by name; at least one.
        items: Vec<(NameKind, SmolStr)>,
    },
    /// The item is there and private.
    ImplementationPrivate {
        /// The identifier.
        alias: SmolStr,
        /// The library's project.
        library: SmolStr,
        /// The item.
        item: SmolStr,
        /// The kind of item.
        what: NameKind,
    },
    /// The item is there with another type, container, parameter or passing.
    ImplementationDifferent {
        /// The identifier.
        alias: SmolStr,
        /// The library's project.
        library: SmolStr,
        /// The item.
        item: SmolStr,
        /// The kind of item.
        what: NameKind,
        /// The declaration of the interface, as a syntax line.
        expected: SmolStr,
        /// The declaration of the library.
        found: SmolStr,
    },
}
