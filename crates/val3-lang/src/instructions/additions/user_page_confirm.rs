//! `userPageConfirm`: shows a question to the operator on the user page.

use crate::call::{Call, Flow, Wait};
use crate::declare::instruction;
use crate::ports::InputKind;
use crate::values::Text;

instruction! {
    /// Asks the operator a question on the user page.
    ///
    /// - `sText`: the question.
    /// - Result: `true` if the operator confirms.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    ///   if userPageConfirm("Empty the gripper?")
    ///     putln("emptying")
    ///   endIf
    /// ```
    "userPageConfirm": Additions, since 8;
    modifier (string sText) -> bool = confirm;
}

fn confirm(call: &mut Call<'_>, text: Text) -> Flow<bool> {
    if call.is_first() {
        call.ports.begin_question(&text, InputKind::Confirmation);
    }
    let answer = call.ports.take_answer();
    answer.map_or(Flow::Wait(Wait::FOR_OTHERS), |answer| Flow::Done(answer.is_accepted()))
}
