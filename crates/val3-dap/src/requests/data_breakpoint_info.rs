//! `dataBreakpointInfo`: whether a value can have a data breakpoint.

use val3_debug::WatchedData;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::inspection::InspectedItem;
use crate::protocol::DataBreakpointAccessType;
use crate::protocol::{DataBreakpointInfoArguments, DataBreakpointInfoResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `dataBreakpointInfo`.
pub(crate) enum DataBreakpointInfo {}

impl DebugRequest for DataBreakpointInfo {
    const COMMAND: &'static str = "dataBreakpointInfo";
    type Arguments = DataBreakpointInfoArguments;
    type Body = DataBreakpointInfoResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: DataBreakpointInfoArguments,
    ) -> Result<DataBreakpointInfoResponse, RequestFailure> {
        let name = arguments.name.as_str();
        let named = match arguments.variables_reference.map(|reference| session.handles.node(reference)) {
            Some(Some(InspectedItem::Values(inside))) => inside.expression(name),
            Some(Some(InspectedItem::Properties(_))) => None,
            Some(None) => return Err(RequestFailure::Stale),
            None => Some((session.context(arguments.frame_id, run)?, name.to_owned())),
        };
        let controller = &mut run.debugger.controller;
        let watched = match named {
            Some((context, path)) => WatchedData::new(controller, context, &path),
            None => Err(format!("`{name}` is computed from other values")),
        };
        let watched = watched.or_else(|reason| WatchedData::signal(controller, name).map_err(|_| reason));
        Ok(match watched {
            Ok(data) => watchable(session.breakpoints.know_data(data)),
            Err(description) => DataBreakpointInfoResponse { description, ..DataBreakpointInfoResponse::default() },
        })
    }
}

fn watchable(id: String) -> DataBreakpointInfoResponse {
    let access_types =
        [DataBreakpointAccessType::Read, DataBreakpointAccessType::Write, DataBreakpointAccessType::ReadWrite];
    DataBreakpointInfoResponse {
        description: id.clone(),
        data_id: Some(id),
        access_types: Some(access_types.to_vec()),
        ..DataBreakpointInfoResponse::default()
    }
}
