//! `userPage` (4.3): shows the user page on the pendant.

use crate::call::{Call, ScreenRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::DEFAULT_PAGE;
use crate::values::Text;

instruction! {
    /// Shows the user page on the pendant.
    ///
    /// - `scPage`: the page to show; without it, the default page.
    /// - `bFixed`: `true` keeps the operator on the user page (the user profile can still be changed), `false` makes
    ///   the other pages available again.
    /// - `sPage` (s8): the name of an HTML page in the `interface` folder of the application.
    ///
    /// ## Example
    /// ```val3
    /// screen scMain
    ///   cls(scMain)
    ///   title(scMain,"Palletiser")
    ///   userPage(scMain)
    /// ```
    "userPage": Screen "4.3";
    modifier () = show;
    modifier (screen scPage) = show_screen;
    modifier (bool bFixed) = fix;
    modifier (string sPage) -> num since 8 = show_html;
}

fn show(call: &mut Call<'_>) {
    call.ports.show_page(DEFAULT_PAGE);
}

fn show_screen(call: &mut Call<'_>, screen: ScreenRef) -> Result<()> {
    let page = screen.page(call)?;
    call.ports.show_page(page);
    Ok(())
}

fn fix(call: &mut Call<'_>, fixed: bool) {
    call.ports.fix_page(fixed);
}

fn show_html(call: &mut Call<'_>, page: Text) -> f64 {
    call.ports.show_html(&page).into()
}
