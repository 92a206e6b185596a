//! `setVariable`: assigns a value to a variable of a scope or a value.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::inspection::InspectedItem;
use crate::protocol::{SetVariableArguments, SetVariableResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `setVariable`.
pub(crate) enum SetVariable {}

impl DebugRequest for SetVariable {
    const COMMAND: &'static str = "setVariable";
    type Arguments = SetVariableArguments;
    type Body = SetVariableResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SetVariableArguments,
    ) -> Result<SetVariableResponse, RequestFailure> {
        let inside = match session.handles.node(arguments.variables_reference).ok_or(RequestFailure::Stale)? {
            InspectedItem::Values(inside) => inside.clone(),
            InspectedItem::Properties(_) => return Err(RequestFailure::NoData(arguments.name)),
        };
        let assignment = (arguments.name.as_str(), arguments.value.as_str());
        let format = session.format(arguments.format.as_ref());
        let value = run.evaluator.assign_child(&mut run.debugger.controller, &inside, assignment, format);
        let value = value.map_err(RequestFailure::rejected)?;
        let variable = session.shown(value, run);
        Ok(SetVariableResponse {
            value: variable.value,
            r#type: variable.r#type,
            variables_reference: Some(variable.variables_reference),
            indexed_variables: variable.indexed_variables,
            named_variables: variable.named_variables,
            ..SetVariableResponse::default()
        })
    }
}
