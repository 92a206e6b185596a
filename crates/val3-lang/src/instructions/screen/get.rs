//! `get` (4.3): waits for the operator: a text, a number or a key.

use crate::call::{Call, Flow, ScreenRef, Var, Wait};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::{DEFAULT_PAGE, InputKind, InputResult, OperatorInput};
use crate::values::Text;
use crate::values::number_text::shown;

instruction! {
    /// Waits for the operator: a text, a number or a key.
    ///
    /// - `scPage`: the page; without it, the default page. Only the displayed page receives keys.
    /// - `sText`, `nValue`: shown at the cursor and edited by the operator. Return or a menu key accepts the entry;
    ///   after Esc, the variable is unchanged. Without a variable, any key ends the wait, and the key is not shown.
    /// - Result: the code of the key: 270 Return, 255 Esc, 271 to 278 the menu keys F1 to F8, 261, 264, 266 and 268 the
    ///   arrows up, left, down and right; for a character its ASCII code.
    ///
    /// The cursor does not move. Other tasks continue.
    ///
    /// ## Example
    /// ```val3
    /// num nSpeed = 50
    /// num nKey
    ///   put("speed: ")
    ///   nKey=get(nSpeed)
    ///   if nKey==270
    ///     putln("accepted")
    ///   endIf
    /// ```
    "get": Screen "4.3", blocking;
    modifier (string& sText) -> num = text;
    modifier (screen scPage, string& sText) -> num = text_on;
    modifier (num& nValue) -> num = number;
    modifier (screen scPage, num& nValue) -> num = number_on;
    modifier () -> num = key;
    modifier (screen scPage) -> num = key_on;
}

fn text(call: &mut Call<'_>, text: Var<Text>) -> Result<Flow<f64>> {
    read_text(call, DEFAULT_PAGE, &text)
}

fn text_on(call: &mut Call<'_>, screen: ScreenRef, text: Var<Text>) -> Result<Flow<f64>> {
    let page = screen.page(call)?;
    read_text(call, page, &text)
}

fn number(call: &mut Call<'_>, value: Var<f64>) -> Result<Flow<f64>> {
    read_number(call, DEFAULT_PAGE, &value)
}

fn number_on(call: &mut Call<'_>, screen: ScreenRef, value: Var<f64>) -> Result<Flow<f64>> {
    let page = screen.page(call)?;
    read_number(call, page, &value)
}

fn key(call: &mut Call<'_>) -> Flow<f64> {
    read_key(call, DEFAULT_PAGE)
}

fn key_on(call: &mut Call<'_>, screen: ScreenRef) -> Result<Flow<f64>> {
    let page = screen.page(call)?;
    Ok(read_key(call, page))
}

fn read_text(call: &mut Call<'_>, page: u32, text: &Var<Text>) -> Result<Flow<f64>> {
    let shown = text.get(call)?.to_string();
    let Some(InputResult { key, entry }) = read(call, page, InputKind::Text(shown)) else { return Ok(WAITS) };
    if let OperatorInput::Text(entered) = entry {
        text.set(call, Text::from(entered.as_str()))?;
    }
    Ok(Flow::Done(key.into()))
}

fn read_number(call: &mut Call<'_>, page: u32, number: &Var<f64>) -> Result<Flow<f64>> {
    let value = number.get(call)?;
    let asked = InputKind::Number { value, shown: shown(value).to_string() };
    let Some(InputResult { key, entry }) = read(call, page, asked) else { return Ok(WAITS) };
    if let OperatorInput::Number(entered) = entry {
        number.set(call, entered)?;
    }
    Ok(Flow::Done(key.into()))
}

fn read_key(call: &mut Call<'_>, page: u32) -> Flow<f64> {
    read(call, page, InputKind::Key).map_or(WAITS, |answer| Flow::Done(answer.key.into()))
}

const WAITS: Flow<f64> = Flow::Wait(Wait::FOR_OTHERS);

/// Requests input at the first call of the instruction. Returns the input when it is available.
fn read(call: &mut Call<'_>, page: u32, asked: InputKind) -> Option<InputResult> {
    if call.is_first() {
        call.ports.begin_reading(page, asked);
    }
    call.ports.take_answer()
}
