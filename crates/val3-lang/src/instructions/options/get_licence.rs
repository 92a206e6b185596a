//! `getLicence` (11.3.2): returns the state of a machine builder's licence.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Returns the state of a machine builder's licence.
    ///
    /// - `sOemLicenceName`: the name of the licence.
    /// - `sOemPassword`: the secret password with which it was created; keep it in an encrypted library.
    /// - Result: `"enabled"`, `"demo"`, `""` if it is missing or the password is wrong, `"oemLicenceDisabled"` if the
    ///   controller cannot test licences.
    ///
    /// ## Example
    /// ```val3
    /// string sPassword
    ///   if getLicence("palletiser",sPassword)!="enabled"
    ///     popUpMsg("No licence for this application")
    ///   endIf
    /// ```
    "getLicence": Options "11.3.2";
    function (string sOemLicenceName, string sOemPassword) -> string = licence;
}

fn licence(call: &mut Call<'_>, name: Text, password: Text) -> Text {
    call.ports.oem_licence(&name, &password)
}
