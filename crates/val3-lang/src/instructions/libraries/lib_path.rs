//! `libPath` (6.7): returns the path of a library, or of the program's own application.

use crate::call::{Call, LibraryRef};
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Returns the path of a library, or of the program's own application.
    ///
    /// - Called on an identifier: the path from which the library was loaded.
    /// - Called without an identifier: the path of the application or library of the calling program.
    /// - Result: the path.
    ///
    /// ## Example
    /// ```val3
    ///   putln(libPath())
    /// ```
    "libPath": Libraries "6.7";
    function () -> string on library = of_library;
    function () -> string = own;
}

/// Empty if no library is loaded under the identifier.
fn of_library(call: &mut Call<'_>, library: LibraryRef) -> Text {
    Text::from(call.tasks.path(Some(library.0)).as_str())
}

fn own(call: &mut Call<'_>) -> Text {
    Text::from(call.tasks.path(None).as_str())
}
