//! `userPagePrompt`: requests a text from the operator on the user page.

use crate::call::{Call, Flow, Var, Wait};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::{InputKind, OperatorInput};
use crate::values::Text;

instruction! {
    /// Asks the operator for a text on the user page.
    ///
    /// - `sPrompt`: the question.
    /// - `sText`: receives the answer.
    /// - Result: `true` if there is an answer.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    /// string sOrder
    ///   if userPagePrompt("Order number",sOrder)
    ///     logMsg("order "+sOrder)
    ///   endIf
    /// ```
    "userPagePrompt": Additions, since 8;
    modifier (string sPrompt, string& sText) -> bool = prompt;
}

fn prompt(call: &mut Call<'_>, question: Text, text: Var<Text>) -> Result<Flow<bool>> {
    if call.is_first() {
        let shown = text.get(call)?.to_string();
        call.ports.begin_question(&question, InputKind::Text(shown));
    }
    let Some(answer) = call.ports.take_answer() else { return Ok(Flow::Wait(Wait::FOR_OTHERS)) };
    if let OperatorInput::Text(entered) = &answer.entry {
        text.set(call, Text::from(entered.as_str()))?;
    }
    Ok(Flow::Done(answer.is_accepted()))
}
