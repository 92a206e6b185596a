//! `libSave` (6.7): saves programs and data of a library, or of the application itself.

use super::lib_load::request;
use crate::call::{Call, Flow, LibraryRef};
use crate::declare::instruction;
use crate::ports::RuntimeRequest;
use crate::values::Text;

instruction! {
    /// Saves programs and data of a library, or of the application itself.
    ///
    /// - Called on an identifier, it saves the library that is loaded there, otherwise the application of the calling
    ///   program.
    /// - `sPath`: the destination; by default the path from which the library was loaded.
    /// - Result: 0 saved; every other number is the reason for the failure: 10 nothing is loaded under the identifier,
    ///   31 a library already exists at `sPath`, 30 the medium has failed, or a file cannot contain one of the values
    ///   (infinite numbers, control characters). Then no file is changed, and the log names the value.
    ///
    /// It never raises a run-time error. Flash memory wears out: do not save once a minute or more often.
    ///
    /// ## Example
    /// ```val3
    /// public point pPick
    ///   if libSave()!=0
    ///     popUpMsg("Points are not saved")
    ///   endIf
    /// ```
    "libSave": Libraries "6.7", blocking;
    modifier () -> num on library = save_library;
    modifier (string sPath) -> num on library = save_library_as;
    modifier () -> num = save_own;
    modifier (string sPath) -> num = save_own_as;
}

fn save_library(call: &mut Call<'_>, library: LibraryRef) -> Flow {
    request(call, RuntimeRequest::Save { library: Some(library.0), path: None })
}

fn save_library_as(call: &mut Call<'_>, library: LibraryRef, path: Text) -> Flow {
    request(call, RuntimeRequest::Save { library: Some(library.0), path: Some(path) })
}

fn save_own(call: &mut Call<'_>) -> Flow {
    request(call, RuntimeRequest::Save { library: None, path: None })
}

fn save_own_as(call: &mut Call<'_>, path: Text) -> Flow {
    request(call, RuntimeRequest::Save { library: None, path: Some(path) })
}
