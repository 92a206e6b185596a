//! `libDelete` (6.7): deletes a library from a disk.

use crate::call::{Call, Flow};
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Deletes a library from a disk.
    ///
    /// - `sPath`: the path (`libLoad` describes paths).
    /// - Result: 0 deleted, also if the library did not exist; every other number is the reason for the failure.
    ///
    /// ## Example
    /// ```val3
    ///   if libDelete("USB0://backup")==0 and libSave("USB0://backup")==0
    ///     popUpMsg("saved")
    ///   endIf
    /// ```
    "libDelete": Libraries "6.7", blocking;
    modifier (string sPath) -> num = delete;
}

fn delete(call: &mut Call<'_>, path: Text) -> Flow<f64> {
    if call.is_first() {
        return call.sleep(0);
    }
    let from = call.tasks.path(None);
    Flow::Done(f64::from(call.ports.delete_library(&from, &path)))
}
