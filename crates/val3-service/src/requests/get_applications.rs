//! `getApplications`: the projects on `Disk`, and all projects in memory.

use val3_soap::SoapFault;
use val3_soap::v1::{GetApplications, GetApplicationsAnswer, ListedApplication};

use crate::applications;
use crate::context::Context;
use crate::projects::unreadable_medium;

/// Answers the request.
pub(super) fn answer(_: &GetApplications, context: &mut Context<'_, '_>) -> Result<GetApplicationsAnswer, SoapFault> {
    let controller = context.controller();
    let mut names = applications::stored(controller).map_err(unreadable_medium)?;
    let loaded: Vec<String> = applications::loaded(controller).map(|(_, name)| name).collect();
    let is_in = |names: &[String], name: &str| names.iter().any(|known| known.eq_ignore_ascii_case(name));
    let others: Vec<String> = loaded.iter().filter(|name| !is_in(&names, name)).cloned().collect();
    names.extend(others);
    let application = |name: String| ListedApplication { loaded: is_in(&loaded, &name), name: Some(name) };
    Ok(GetApplicationsAnswer { applications: names.into_iter().map(application).collect() })
}
