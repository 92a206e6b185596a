//! Data that a client names in a request.

use val3_debug::{DisplayFormat, WatchedData};
use val3_session::Purpose;

use super::DebugSession;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::inspection::InspectedItem;

/// Data that a client names: a value nested in another value, or an expression in a stack frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NamedData<'a> {
    /// Name of the value, expression, or path of a signal.
    pub(crate) name: &'a str,
    /// Handle of the enclosing value.
    pub(crate) variables_reference: Option<i32>,
    /// Handle of the stack frame.
    pub(crate) frame: Option<i32>,
}

impl DebugSession {
    /// Returns the data with an id from an earlier response, or the named data.
    ///
    /// # Errors
    /// The client has named no data, or there are no such data.
    pub(crate) fn chosen_data(
        &self,
        id: Option<&str>,
        named: Option<&NamedData<'_>>,
        run: &mut DebuggedRun<'_>,
    ) -> Result<WatchedData, RequestFailure> {
        if let Some(id) = id {
            let known = self.breakpoints.known_data(id).cloned();
            return known.ok_or_else(|| RequestFailure::Rejected(format!("`{id}` is not known in this run")));
        }
        let required = || RequestFailure::Rejected("`name` or `dataId` is required".to_owned());
        self.named_data(named.ok_or_else(required)?, run)?.map_err(RequestFailure::Rejected)
    }

    /// Returns the named variable, element, field or signal. Indexes in an expression are evaluated now. The inner
    /// error is the reason why there are no such data, for users.
    ///
    /// # Errors
    /// A handle is stale, or no application is loaded.
    pub(crate) fn named_data(
        &self,
        named: &NamedData<'_>,
        run: &mut DebuggedRun<'_>,
    ) -> Result<Result<WatchedData, String>, RequestFailure> {
        let name = named.name;
        let mut signal = name;
        let place = match named.variables_reference.map(|reference| self.handles.node(reference)) {
            Some(Some(InspectedItem::Values(inside))) => inside.expression(name),
            Some(Some(InspectedItem::Properties(properties))) => {
                let property = properties.iter().find(|property| property.name == name);
                signal = property.and_then(|property| property.signal.as_deref()).unwrap_or(name);
                None
            }
            Some(Some(InspectedItem::Libraries(_))) => None,
            Some(None) => return Err(RequestFailure::Stale),
            None => Some((self.context(named.frame, run)?, name.to_owned())),
        };
        let controller = &mut run.debugger.controller;
        let data = match place {
            Some((context, path)) => WatchedData::new(controller, context, &path).or_else(|reason| {
                let value =
                    run.evaluator.evaluate(controller, context, &path, Purpose::Watch, DisplayFormat::default()).ok();
                let constant = value.and_then(|evaluation| evaluation.value?.refers_to);
                constant.map_or(Err(reason), |path| WatchedData::new(controller, context, &path))
            }),
            None => Err(format!("`{name}` is computed from other values")),
        };
        Ok(data.or_else(|reason| WatchedData::signal(controller, signal).map_err(|_| reason)))
    }
}
