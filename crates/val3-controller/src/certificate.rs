//! Fingerprints of certificates, by which a controller with TLS is recognized.

use std::fmt::{self, Display};
use std::str::FromStr;

use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

/// Name of the hash in the text form.
const HASH: &str = "SHA256";

/// SHA-256 hash of a server's certificate. The text form is that of certificate viewers with the hash in front:
/// `SHA256:3F:A1:…`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct CertificateFingerprint([u8; 32]);

impl CertificateFingerprint {
    /// Computes the fingerprint of a certificate in DER.
    pub(crate) fn of(certificate: &[u8]) -> Self {
        Self(Sha256::digest(certificate).into())
    }
}

/// A text is no fingerprint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FingerprintFault;

impl FromStr for CertificateFingerprint {
    type Err = FingerprintFault;

    /// Parses a fingerprint with or without the name of the hash and the colons, in any letter case.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let text = text.trim();
        let digits = match text.split_at_checked(HASH.len()) {
            Some((name, rest)) if name.eq_ignore_ascii_case(HASH) => rest.strip_prefix(':').ok_or(FingerprintFault)?,
            _ => text,
        };
        let digits: Vec<u8> = digits.bytes().filter(|byte| *byte != b':').collect();
        let (pairs, []) = digits.as_chunks::<2>() else { return Err(FingerprintFault) };
        let bytes = pairs.iter().map(|pair| byte(*pair)).collect::<Option<Vec<u8>>>().ok_or(FingerprintFault)?;
        bytes.try_into().map(Self).map_err(|_| FingerprintFault)
    }
}

/// Parses two hexadecimal digits.
fn byte(pair: [u8; 2]) -> Option<u8> {
    let [high, low] = pair.map(|digit| char::from(digit).to_digit(16));
    u8::try_from(high? * 16 + low?).ok()
}

impl Display for CertificateFingerprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(HASH)?;
        self.0.iter().try_for_each(|byte| write!(f, ":{byte:02X}"))
    }
}

impl Display for FingerprintFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a fingerprint is `{HASH}:` and 64 hexadecimal digits")
    }
}

impl std::error::Error for FingerprintFault {}

impl From<CertificateFingerprint> for String {
    fn from(fingerprint: CertificateFingerprint) -> Self {
        fingerprint.to_string()
    }
}

impl TryFrom<String> for CertificateFingerprint {
    type Error = FingerprintFault;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fingerprint_is_read_in_the_forms_of_other_tools() {
        let fingerprint = CertificateFingerprint::of(b"certificate");
        let text = fingerprint.to_string();
        assert_eq!((&text[..10], text.len()), ("SHA256:03:", 102));
        let digits = text.trim_start_matches("SHA256:");
        for form in [text.clone(), text.to_lowercase(), digits.to_owned(), digits.replace(':', "").to_lowercase()] {
            assert_eq!(form.parse(), Ok(fingerprint), "{form}");
        }
    }

    #[test]
    fn other_texts_are_no_fingerprints() {
        let text = CertificateFingerprint::of(b"certificate").to_string();
        for wrong in ["", "SHA256", "SHA256:", "SHA256:zz", &text[..99], &format!("{text}:00"), "MD5:00", "é"] {
            assert_eq!(wrong.parse::<CertificateFingerprint>(), Err(FingerprintFault), "{wrong}");
        }
    }
}
