//! Evaluation, assignment, completions, data breakpoints and targets of `goto`: requests about code in a frame.

use val3_debug::{Format, Value, WatchedData, count, values};
use val3_session::{Evaluation, EvaluationError, Purpose};
use val3_vm::FragmentContext;

use super::requests::gone;
use super::{DebugSession, Refusal, Target};
use crate::breakpoints::file_of;
use crate::inspection::{FrameHandle, Node};
use crate::protocol::{
    CompletionItem, CompletionsArguments, CompletionsResponse, DataBreakpointAccessType, DataBreakpointInfoArguments,
    DataBreakpointInfoResponse, EvaluateArguments, EvaluateContext, EvaluateResponse, GotoTarget, GotoTargetsArguments,
    GotoTargetsResponse, SetExpressionArguments, SetExpressionResponse, SetVariableArguments, SetVariableResponse,
    ValueFormat, Variable,
};

impl DebugSession {
    /// The format that the client asks for.
    pub(super) fn format(&self, format: Option<&ValueFormat>) -> Format {
        let hex = format.and_then(|format| format.hex).unwrap_or_default();
        Format { hex, radians: self.start.settings.has_radians }
    }

    /// Where code of a frame is evaluated; without one, in the first application in memory.
    fn context(&self, frame: Option<i32>, target: &Target<'_>) -> Result<FragmentContext, Refusal> {
        if let Some(frame) = frame {
            let FrameHandle { task, depth } = self.handles.frame(frame).ok_or_else(gone)?;
            return Ok(FragmentContext::Frame(task, depth));
        }
        let first = target.debugger.controller.vm.space.loaded().next().map(|(instance, _)| instance);
        first.map(FragmentContext::Instance).ok_or_else(|| "no application is in memory".to_owned())
    }

    pub(super) fn evaluate(
        &mut self,
        request: i64,
        arguments: &EvaluateArguments,
        target: &mut Target<'_>,
    ) -> Result<EvaluateResponse, Refusal> {
        let context = self.context(arguments.frame_id, target)?;
        let purpose = match arguments.context {
            Some(EvaluateContext::Repl) => Purpose::Execute,
            _ => Purpose::Watch,
        };
        let how = (purpose, self.format(arguments.format.as_ref()));
        let controller = &mut target.debugger.controller;
        let client = &mut self.client;
        let mut is_cancelled = false;
        let mut may_go_on = || {
            is_cancelled = client.has_cancelled(request, "");
            !is_cancelled
        };
        let evaluated =
            target.evaluator.evaluate_while(controller, context, &arguments.expression, how, &mut may_go_on);
        let changes_run = match &evaluated {
            Ok(evaluation) => evaluation.changes_run,
            Err(error) => error.done().is_some_and(|done| done.changes_run),
        };
        if changes_run {
            self.tell_of_new_future(target);
            target.debugger.begin_new_future();
            self.changed_by_hand(target);
        }
        let reason = |error: EvaluationError| if is_cancelled { "cancelled".to_owned() } else { error.to_string() };
        let Evaluation { value, output, .. } = evaluated.map_err(reason)?;
        let is_whole = arguments.context == Some(EvaluateContext::Clipboard);
        let list = value.as_ref().filter(|_| is_whole).and_then(|value| list(value, target, how.1));
        let variable = value.map(|value| self.shown(value, target)).unwrap_or_default();
        let mut lines = output;
        lines.extend(Some(list.unwrap_or(variable.value)).filter(|value| !value.is_empty()));
        Ok(EvaluateResponse {
            result: lines.join("\n"),
            r#type: variable.r#type,
            variables_reference: variable.variables_reference,
            indexed_variables: variable.indexed_variables,
            named_variables: variable.named_variables,
            ..EvaluateResponse::default()
        })
    }

    fn shown(&mut self, value: Value, target: &mut Target<'_>) -> Variable {
        self.handles.variable(value, &mut target.debugger.controller)
    }

    pub(super) fn set_variable(
        &mut self,
        arguments: &SetVariableArguments,
        target: &mut Target<'_>,
    ) -> Result<SetVariableResponse, Refusal> {
        let inside = match self.handles.node(arguments.variables_reference).ok_or_else(gone)? {
            Node::Values(inside) => inside.clone(),
            Node::Properties(_) => {
                return Err(format!("`{}` is not data of a program; use `val3/operate`", arguments.name));
            }
        };
        let assignment = (arguments.name.as_str(), arguments.value.as_str());
        let controller = &mut target.debugger.controller;
        let format = self.format(arguments.format.as_ref());
        let value = target.evaluator.assign_child(controller, &inside, assignment, format);
        let value = value.map_err(|error| error.to_string())?;
        let Variable { value, r#type, variables_reference, indexed_variables, named_variables, .. } =
            self.assigned(value, target);
        Ok(SetVariableResponse {
            value,
            r#type,
            variables_reference: Some(variables_reference),
            indexed_variables,
            named_variables,
            ..SetVariableResponse::default()
        })
    }

    pub(super) fn set_expression(
        &mut self,
        arguments: &SetExpressionArguments,
        target: &mut Target<'_>,
    ) -> Result<SetExpressionResponse, Refusal> {
        let context = self.context(arguments.frame_id, target)?;
        let assignment = (arguments.expression.as_str(), arguments.value.as_str());
        let controller = &mut target.debugger.controller;
        let value = target.evaluator.assign(controller, context, assignment, self.format(arguments.format.as_ref()));
        let value = value.map_err(|error| error.to_string())?;
        let Variable { value, r#type, variables_reference, indexed_variables, named_variables, .. } =
            self.assigned(value, target);
        Ok(SetExpressionResponse {
            value,
            r#type,
            variables_reference: Some(variables_reference),
            indexed_variables,
            named_variables,
            ..SetExpressionResponse::default()
        })
    }

    /// Data have another value: a new future begins.
    fn assigned(&mut self, value: Value, target: &mut Target<'_>) -> Variable {
        self.tell_of_new_future(target);
        target.debugger.begin_new_future();
        self.changed_by_hand(target);
        self.shown(value, target)
    }

    pub(super) fn completions(
        &mut self,
        arguments: &CompletionsArguments,
        target: &mut Target<'_>,
    ) -> Result<CompletionsResponse, Refusal> {
        let context = self.context(arguments.frame_id, target)?;
        // The console may have several lines; the column belongs to this one.
        let number = arguments.line.map_or(0, |line| self.conventions.row(line).saturating_sub(1)) as usize;
        let text = arguments.text.lines().nth(number).unwrap_or_default();
        let at = byte_offset(text, self.conventions.offset(arguments.column));
        let found = target.evaluator.completions(&target.debugger.controller, context, (text, at));
        let item = |completion: val3_session::FrameCompletion| {
            let characters = |byte: usize| text.get(..byte).map_or(0, |before| before.encode_utf16().count());
            let (start, end) = (characters(completion.range.start), characters(completion.range.end));
            CompletionItem {
                label: completion.label,
                detail: Some(completion.detail).filter(|detail| !detail.is_empty()),
                text: Some(completion.insert),
                start: u32::try_from(start).ok(),
                length: u32::try_from(end.saturating_sub(start)).ok(),
                ..CompletionItem::default()
            }
        };
        let found = found.map_err(|error| error.to_string())?;
        Ok(CompletionsResponse { targets: found.into_iter().map(item).collect() })
    }

    pub(super) fn data_breakpoint_info(
        &mut self,
        arguments: &DataBreakpointInfoArguments,
        target: &mut Target<'_>,
    ) -> Result<DataBreakpointInfoResponse, Refusal> {
        let name = arguments.name.as_str();
        let named = match arguments.variables_reference.map(|reference| self.handles.node(reference)) {
            Some(Some(Node::Values(inside))) => inside.expression(name),
            Some(Some(Node::Properties(_))) => None,
            Some(None) => return Err(gone()),
            None => Some((self.context(arguments.frame_id, target)?, name.to_owned())),
        };
        let controller = &mut target.debugger.controller;
        let watched = match named {
            Some((context, path)) => WatchedData::new(controller, context, &path),
            None => Err(format!("`{name}` is computed from other values")),
        };
        let watched = watched.or_else(|reason| WatchedData::signal(controller, name).map_err(|_| reason));
        Ok(match watched {
            Ok(data) => {
                let id = self.breakpoints.know_data(data);
                let access_types = [
                    DataBreakpointAccessType::Read,
                    DataBreakpointAccessType::Write,
                    DataBreakpointAccessType::ReadWrite,
                ];
                DataBreakpointInfoResponse {
                    description: id.clone(),
                    data_id: Some(id),
                    access_types: Some(access_types.to_vec()),
                    ..DataBreakpointInfoResponse::default()
                }
            }
            Err(description) => DataBreakpointInfoResponse { description, ..DataBreakpointInfoResponse::default() },
        })
    }

    pub(super) fn goto_targets(
        &mut self,
        arguments: &GotoTargetsArguments,
        target: &mut Target<'_>,
    ) -> Result<GotoTargetsResponse, Refusal> {
        let controller = &target.debugger.controller;
        let file =
            file_of(&arguments.source, controller).ok_or("the application has loaded no program of this file")?;
        let row = self.conventions.row(arguments.line);
        let tasks = controller.vm.tasks().iter().map(|task| task.id);
        let found = tasks.filter_map(|task| target.debugger.goto_target(task, &file, row).ok()).next();
        let targets = found.map(|found| {
            let id = i32::try_from(self.goto_targets.len() + 1).unwrap_or(i32::MAX);
            self.goto_targets.insert(id, (file.clone(), row));
            let label = if found.is_end { "the end of the program".to_owned() } else { format!("line {}", found.row) };
            GotoTarget { id, label, line: self.conventions.line(found.row), ..GotoTarget::default() }
        });
        Ok(GotoTargetsResponse { targets: targets.into_iter().collect() })
    }
}

/// All values of an array or collection as one text.
fn list(value: &Value, target: &mut Target<'_>, format: Format) -> Option<String> {
    let inside = value.inside.as_ref().filter(|inside| inside.is_indexed())?;
    let controller = &mut target.debugger.controller;
    let all = 0..count(&mut controller.vm, inside);
    let texts = values(controller, inside, all, format).into_iter().map(|value| value.shown);
    Some(format!("{{{}}}", texts.collect::<Vec<_>>().join(", ")))
}

/// The byte at a number of UTF-16 units.
fn byte_offset(text: &str, units: usize) -> usize {
    let mut count = 0;
    for (at, character) in text.char_indices() {
        if count >= units {
            return at;
        }
        count += character.len_utf16();
    }
    text.len()
}
