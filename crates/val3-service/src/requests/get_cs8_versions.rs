//! `getCS8Versions`: the versions that programs read with `getVersion`.

use val3_soap::SoapFault;
use val3_soap::v0::{GetCs8Versions, GetCs8VersionsAnswer, SoftwareVersion};

use crate::context::Context;

/// Parts of the software: the name as in `val3version.xml`, and the name for the query.
const PARTS: [(&str, &str); 3] = [("val3", "VAL 3"), ("system", "System"), ("starc", "Starc")];

/// Answers the request.
pub(super) fn answer(_: &GetCs8Versions, context: &mut Context<'_, '_>) -> Result<GetCs8VersionsAnswer, SoapFault> {
    let versions = &context.controller().devices.state.versions;
    let part = |(name, component): (&str, &str)| {
        let version = Some(versions.version(component)).filter(|version| !version.is_empty())?;
        Some(SoftwareVersion { name: Some(name.to_owned()), version: Some(version.to_owned()) })
    };
    Ok(GetCs8VersionsAnswer { versions: PARTS.into_iter().filter_map(part).collect() })
}
