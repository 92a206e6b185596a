//! `getVersion` (8.1): returns the version or the state of a controller part.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Returns the version or the state of a controller part.
    ///
    /// - `sComponent`: `"VAL 3"`, `"ArmType"`, `"Tuning"`, `"Mounting"`, `"ControllerSN"`, `"ArmSN"`, `"Starc"`, or the
    ///   name of a software licence such as `"alter"`, `"compliance"`, `"oemLicence"`.
    /// - Result: the version; for a licence `"enabled"`, `"demo"`, or `""` if it is missing or has expired.
    ///
    /// ## Example
    /// ```val3
    ///   if getVersion("alter")!="enabled"
    ///     popUpMsg("The alter licence is missing")
    ///   endIf
    /// ```
    "getVersion": Controller "8.1";
    function (string sComponent) -> string = version;
}

fn version(call: &mut Call<'_>, component: Text) -> Text {
    call.ports.version(&component)
}
