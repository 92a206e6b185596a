//! `getCS8Versions`: the versions that programs read with `getVersion`.

use val3_soap::SoapFault;
use val3_soap::v0::{GetCs8Versions, GetCs8VersionsAnswer, SoftwareVersion};

use crate::context::Context;

/// Parts of the software: the name as in `val3version.xml`, and the name for the query.
const PARTS: [(&str, &str); 3] = [("val3", "VAL 3"), ("system", "System"), ("starc", "Starc")];

/// Answers the request.
pub(super) fn answer(_: &GetCs8Versions, context: &mut Context<'_, '_>) -> Result<GetCs8VersionsAnswer, SoapFault> {
    let versions = &context.controller().devices.state.versions;
    let parts = PARTS.into_iter().map(|(name, component)| (name, versions.version(component)));
    let installed = parts.filter(|(_, version)| !version.is_empty());
    Ok(GetCs8VersionsAnswer { versions: installed.map(|(name, version)| software_version(name, version)).collect() })
}

/// Version of a part of the software.
fn software_version(name: &str, version: &str) -> SoftwareVersion {
    SoftwareVersion { name: Some(name.to_owned()), version: Some(version.to_owned()) }
}
