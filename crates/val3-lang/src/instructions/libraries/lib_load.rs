//! `libLoad` (6.7): loads a library under an identifier of the application.

use crate::call::{Call, Flow, LibraryRef};
use crate::declare::instruction;
use crate::ports::RuntimeRequest;
use crate::values::Text;

instruction! {
    /// Loads a library under an identifier of the application.
    ///
    /// - `sPath`: the path: `root://folder/name`. The root is `Disk` (the default), `USB0` or a network connection;
    ///   `./` starts at the application. An encrypted library is a `.zip` file.
    /// - `sPassword`: the public password of an encrypted library.
    /// - Result: 0 loaded; 11 loaded, but its interface differs from the declared one (the use of a missing item raises
    ///   error 80); every other number is the reason why nothing was loaded.
    ///
    /// It never raises a run-time error. Two identifiers that load the same library share its data.
    ///
    /// ## Example
    /// ```val3
    /// library part "Disk://part/part.pjx" autoload=false
    /// num nCode
    ///   nCode=part:libLoad("Disk://bolt")
    ///   if nCode!=0
    ///     logMsg("part not loaded: "+toString("",nCode))
    ///   endIf
    /// --- part
    /// public num nWeight
    /// --- bolt
    /// public num nWeight
    /// ```
    "libLoad": Libraries "6.7", blocking;
    modifier (string sPath) -> num on library = load;
    modifier (string sPath, string sPassword) -> num on library = load_encrypted;
}

fn load(call: &mut Call<'_>, library: LibraryRef, path: Text) -> Flow {
    load_encrypted(call, library, path, Text::new())
}

fn load_encrypted(call: &mut Call<'_>, library: LibraryRef, path: Text, password: Text) -> Flow {
    request(call, RuntimeRequest::Load { library: library.0, path, password })
}

/// Passes the turn to the other tasks, then sends a request. The runtime returns its result code.
pub(super) fn request(call: &mut Call<'_>, request: RuntimeRequest) -> Flow {
    if call.is_first() {
        return call.sleep(0);
    }
    call.tasks.request(request);
    Flow::Done(())
}
