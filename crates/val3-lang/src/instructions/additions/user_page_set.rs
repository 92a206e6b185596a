//! `userPageSet`: changes an element of a user page.

use crate::call::{Any, Call, StoredValue};
use crate::declare::instruction;
use crate::fault::{Fault, Result};
use crate::types::BaseType;
use crate::values::Text;
use crate::values::number_text::shown;
use crate::values::printed;

instruction! {
    /// Changes an element of a user page.
    ///
    /// - `sPage`: the name of the page on the controller.
    /// - `sId`: the id of the element in the page.
    /// - `sAttribute`: the property that changes, such as `"innerHTML"` or `"style.backgroundColor"`.
    /// - `value`: its new value: a text, a number or a truth value.
    /// - Error 70: a value of another type.
    ///
    /// On CS9 controllers user pages are HTML files of the application.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    /// num nDone
    ///   userPageSet("main","lblDone","innerHTML",toString("",nDone))
    /// ```
    "userPageSet": Additions, errors [70], since 8;
    modifier (string sPage, string sId, string sAttribute, any value) = set;
}

fn set(call: &mut Call<'_>, page: Text, id: Text, attribute: Text, value: Any) -> Result<()> {
    let text = match value.base {
        Some(BaseType::String) => Text::read(call.memory, value.place)?,
        Some(BaseType::Num) => shown(f64::read(call.memory, value.place)?),
        Some(BaseType::Bool) => Text::from(printed::bool(bool::read(call.memory, value.place)?)),
        _ => return Err(Fault::INVALID_PARAMETER),
    };
    call.ports.set_html(&page, &id, &attribute, &text);
    Ok(())
}
