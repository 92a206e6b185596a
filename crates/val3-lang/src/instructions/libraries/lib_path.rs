use crate::declare::instruction;

instruction! {
    /// Gives the path of a library, or of the program's own application.
    ///
    /// - Called on an identifier: the path from which the library was loaded.
    /// - Called alone: the path of the application or library in which the calling program stands.
    /// - Result: the path.
    ///
    /// ## Example
    /// ```val3
    ///   putln(libPath())
    /// ```
    "libPath": Libraries "6.7";
    function () -> string on library;
    function () -> string;
}
