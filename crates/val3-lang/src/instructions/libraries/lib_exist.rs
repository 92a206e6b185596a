//! `libExist` (6.7): returns whether the library under an identifier has a public variable or program.

use crate::call::{Call, LibraryRef};
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Returns whether the library under an identifier has a public variable or program.
    ///
    /// - `sSymbolName`: the name; the name of a program is followed by `()`: `"init()"`.
    /// - Result: `true` if it exists and is public.
    ///
    /// An application can thus support older and newer versions of a library; see also `isDefined`.
    ///
    /// ## Example
    /// ```val3
    /// library part "Disk://part/part.pjx"
    ///   if part:libExist("init()")
    ///     call part:init()
    ///   endIf
    /// --- part
    /// public program init()
    /// begin
    /// end
    /// ```
    "libExist": Libraries "6.7";
    function (string sSymbolName) -> bool on library = exists;
}

/// Returns `false` if no library is loaded under the identifier.
fn exists(call: &mut Call<'_>, library: LibraryRef, symbol: Text) -> bool {
    call.tasks.exports(library.0, &symbol)
}
