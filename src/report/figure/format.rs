//! The languages that figures are written in: SVG, and with the feature `figures` PNG and PDF.

use std::path::Path;
use std::sync::OnceLock;

use super::Figure;
use crate::report::ReportError;

/// A language of figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FigureFormat {
    Svg,
    Png,
    Pdf,
}

impl FigureFormat {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Svg, Self::Png, Self::Pdf];

    /// Its name, which is the ending of its files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Png => "png",
            Self::Pdf => "pdf",
        }
    }

    /// Whether this build writes it.
    pub fn is_built(self) -> bool {
        self == Self::Svg || cfg!(feature = "figures")
    }

    /// The language that the ending of a file asks for; SVG where it asks for none.
    pub fn of(file: &Path) -> Self {
        let ending = file.extension().unwrap_or_default();
        let found = Self::ALL.into_iter().find(|each| ending == each.name());
        found.unwrap_or(Self::Svg)
    }
}

/// Languages of the figures of all folders.
static FORMATS: OnceLock<Vec<FigureFormat>> = OnceLock::new();

/// Lets all folders from here on have their figures in these languages.
pub(crate) fn write_figures_as(formats: &[FigureFormat]) {
    let _ = FORMATS.set(formats.to_vec());
}

/// Languages of the figures of all folders: SVG unless others are asked for.
pub(in crate::report) fn figure_formats() -> &'static [FigureFormat] {
    FORMATS.get().map_or(&[FigureFormat::Svg], Vec::as_slice)
}

impl Figure {
    /// The figure in a language.
    ///
    /// # Errors
    /// [`ReportError::Draw`] where the drawing library fails, or this build does not write that language.
    pub fn bytes(&self, format: FigureFormat) -> Result<Vec<u8>, ReportError> {
        let svg = self.svg()?;
        let drawn = match format {
            FigureFormat::Svg => Ok(svg.into_bytes()),
            other => converted(&svg, other),
        };
        drawn.map_err(|source| ReportError::Draw {
            figure: format!("{}.{}", self.name(), format.name()),
            source,
        })
    }
}

/// What the drawing libraries answer.
type Converted = Result<Vec<u8>, Box<dyn std::error::Error + Send + Sync>>;

#[cfg(not(feature = "figures"))]
fn converted(_svg: &str, _format: FigureFormat) -> Converted {
    Err("this build writes figures as SVG alone; build it with `--features figures`".into())
}

#[cfg(feature = "figures")]
mod drawn {
    //! What the libraries `resvg` and `svg2pdf` make of a figure.

    use std::sync::{Arc, LazyLock};

    use resvg::tiny_skia::{Pixmap, Transform};
    use resvg::usvg::{Options, Tree, fontdb};
    use svg2pdf::{ConversionOptions, PageOptions};

    use super::{Converted, FigureFormat};

    /// Pixels of a PNG for each of the figure: 300 an inch where it is 180 mm wide.
    const PIXELS: f32 = 2.4;
    /// Pixels of the figure an inch of a PDF, which makes that 180 mm wide.
    const PER_INCH: f32 = 127.0;

    pub(super) fn converted(svg: &str, format: FigureFormat) -> Converted {
        let fonts = FONTS.clone();
        let fontdb = fonts.ok_or("no font is installed that its texts could be written in")?;
        let options = Options {
            fontdb,
            ..Options::default()
        };
        let tree = Tree::from_str(svg, &options)?;
        if format == FigureFormat::Pdf {
            let page = PageOptions { dpi: PER_INCH };
            let pdf = svg2pdf::to_pdf(&tree, ConversionOptions::default(), page);
            return pdf.map_err(|error| error.to_string().into());
        }
        let size = tree.size().to_int_size().scale_by(PIXELS);
        let pixels = size.and_then(|size| Pixmap::new(size.width(), size.height()));
        let mut pixels = pixels.ok_or("it is too large")?;
        let scale = Transform::from_scale(PIXELS, PIXELS);
        resvg::render(&tree, scale, &mut pixels.as_mut());
        Ok(pixels.encode_png()?)
    }

    /// The fonts that are installed; none without any.
    static FONTS: LazyLock<Option<Arc<fontdb::Database>>> = LazyLock::new(|| {
        let mut fonts = fontdb::Database::new();
        fonts.load_system_fonts();
        let family = sans_serif(&fonts)?;
        fonts.set_sans_serif_family(family);
        Some(Arc::new(fonts))
    });

    /// A font that is installed: a common one without serifs, or any.
    fn sans_serif(fonts: &fontdb::Database) -> Option<String> {
        const COMMON: [&str; 5] = [
            "Arial",
            "Helvetica",
            "Liberation Sans",
            "DejaVu Sans",
            "Noto Sans",
        ];
        let families = || fonts.faces().flat_map(|face| &face.families);
        let is_there = |name: &&str| families().any(|(known, _)| known == *name);
        let common = COMMON.into_iter().find(is_there).map(str::to_owned);
        common.or_else(|| families().next().map(|(name, _)| name.clone()))
    }
}

#[cfg(feature = "figures")]
use drawn::converted;
