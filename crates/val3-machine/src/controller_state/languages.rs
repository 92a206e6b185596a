//! Language of the controller (`getLanguage`, `setLanguage`, 4.3).

/// Languages of the manual's example, and Chinese, which is in another example.
const USUAL: [&str; 6] = ["english", "francais", "deutsch", "italiano", "espanol", "chinese"];

/// Installed languages, and the active language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Languages {
    installed: Vec<String>,
    active: String,
}

impl Default for Languages {
    fn default() -> Self {
        Self::new(USUAL.map(str::to_owned).to_vec(), "english")
    }
}

impl Languages {
    /// Installed languages, and the active language.
    #[must_use]
    pub fn new(installed: Vec<String>, active: &str) -> Self {
        Self { installed, active: active.to_owned() }
    }

    /// `getLanguage`.
    #[must_use]
    pub fn active(&self) -> &str {
        &self.active
    }

    /// Adds a language unless it is installed.
    pub fn install(&mut self, language: &str) {
        if !self.installed.iter().any(|known| known == language) {
            self.installed.push(language.to_owned());
        }
    }

    /// `setLanguage`: returns `false` if the language is not installed. Letter case counts.
    pub fn change(&mut self, language: &str) -> bool {
        let installed = self.installed.iter().any(|known| known == language);
        if installed {
            language.clone_into(&mut self.active);
        }
        installed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_installed_languages_can_be_chosen() {
        let mut languages = Languages::new(vec!["english".to_owned(), "deutsch".to_owned()], "english");
        assert!(languages.change("deutsch"));
        assert!(!languages.change("chinese"));
        assert_eq!(languages.active(), "deutsch");
    }

    #[test]
    fn the_languages_of_the_manual_are_installed() {
        let mut languages = Languages::default();
        assert_eq!(languages.active(), "english");
        assert!(USUAL.iter().all(|language| languages.change(language)));
    }
}
