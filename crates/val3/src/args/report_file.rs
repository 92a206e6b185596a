//! Value of `--output FORMAT=FILE`.

use std::str::FromStr;

use camino::Utf8PathBuf;
use clap::ValueEnum;

use crate::format::ReportFormat;

/// An output file and its format.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct ReportOutput<F = ReportFormat> {
    /// Format.
    pub(crate) format: F,
    /// Path; an existing file is replaced.
    pub(crate) path: Utf8PathBuf,
}

impl<F: ValueEnum> FromStr for ReportOutput<F> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (format, path) = text
            .split_once('=')
            .filter(|(_, path)| !path.is_empty())
            .ok_or("write FORMAT=FILE, for example json=report.json")?;
        let format = F::from_str(format, true).map_err(|_| unknown_format::<F>(format))?;
        Ok(Self { format, path: path.into() })
    }
}

fn unknown_format<F: ValueEnum>(name: &str) -> String {
    let formats = F::value_variants().iter().filter_map(F::to_possible_value);
    let names: Vec<_> = formats.map(|format| format.get_name().to_owned()).collect();
    format!("`{name}` is not a format; supported formats:  {}", names.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_output_names_format_and_file() {
        let output: ReportOutput = "json-lines=out/a=b.json".parse().unwrap();
        assert_eq!(output.format, ReportFormat::JsonLines);
        assert_eq!(output.path, "out/a=b.json");
        assert!("json".parse::<ReportOutput>().is_err());
        assert!("json=".parse::<ReportOutput>().is_err());
        assert!("yaml=x".parse::<ReportOutput>().unwrap_err().contains("concise"));
    }
}
