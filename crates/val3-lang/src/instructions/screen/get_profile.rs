//! `getProfile` (4.3): returns the name of the active user profile.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Returns the name of the active user profile.
    ///
    /// - Result: the name.
    ///
    /// ## Example
    /// ```val3
    ///   putln("profile: "+getProfile())
    /// ```
    "getProfile": Screen "4.3";
    function () -> string = profile;
}

fn profile(call: &mut Call<'_>) -> Text {
    call.ports.profile()
}
