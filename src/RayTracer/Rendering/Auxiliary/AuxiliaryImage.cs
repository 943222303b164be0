using System.Globalization;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// An image of what is known of each pixel besides its light ("arbitrary output variables"): all that anybody knows of it. The command and
/// the Studio offer those of <see cref="Known"/>, to which other assemblies add theirs. Objects of one type are equal.
/// </summary>
public abstract record AuxiliaryImage
{
    /// <summary>The images, in the order in which they are listed.</summary>
    public static Registry<AuxiliaryImage> Known { get; } = new(
        "auxiliary image",
        i => [i.Name],
        new DepthImage(),
        new NormalImage(),
        new AlbedoImage(),
        new UvImage(),
        new MotionImage(),
        new PrimitiveImage(),
        new CryptomatteImage(CryptomatteKind.Object),
        new CryptomatteImage(CryptomatteKind.Material),
        new BvhCostImage(),
        new LuminanceImage(),
        new SamplesImage(),
        new ErrorImage());

    /// <summary>The name, as users write it and files have it.</summary>
    public abstract string Name { get; }

    /// <summary>The name that people read.</summary>
    public abstract string Title { get; }

    /// <summary>The content of the image, in a sentence or two.</summary>
    public abstract string Description { get; }

    /// <summary>The letters of the channels of a layer, one for each number of a pixel.</summary>
    public virtual string Letters => "Y";

    /// <summary>True where the numbers are whole ones that name or count things, rather than means.</summary>
    public virtual bool IsWhole => false;

    /// <summary>
    /// True where a few numbers would leave nothing but black to the others: <see cref="NumberRange.Top"/> leaves them out.
    /// </summary>
    public virtual bool IsSkewed => false;

    /// <summary>True where <see cref="Show"/> returns light rather than display values.</summary>
    public virtual bool ShowsLight => false;

    /// <summary>The colours of a legend, display values from the left to the right.</summary>
    public virtual IReadOnlyList<Rgb> Scale => [Rgb.Black, Rgb.White];

    /// <summary>Returns why a scene has no such image; null where it has.</summary>
    public virtual string? Complaint(Scene scene) => null;

    /// <summary>Returns what the colours mean, for the reader of the picture.</summary>
    /// <param name="range">The range of all numbers.</param>
    public abstract string Legend(NumberRange range);

    /// <summary>Returns a pixel's colour in a picture to look at: display values (sRGB-encoded), cut off at 0 and 1.</summary>
    /// <param name="values">The pixel's numbers.</param>
    /// <param name="range">The range of all numbers.</param>
    public abstract (double R, double G, double B) Show(ReadOnlySpan<double> values, NumberRange range);

    /// <summary>Returns a grey.</summary>
    protected static (double R, double G, double B) Grey(double display) => (display, display, display);

    /// <summary>Returns a colour of the heat map.</summary>
    /// <param name="fraction">0 to 1.</param>
    protected static (double R, double G, double B) Heat(double fraction) => HeatMap.Color(fraction) is var c ? (c.R, c.G, c.B) : default;

    /// <summary>Returns a number as legends have it.</summary>
    protected static string Text(double value) => value.ToString("G6", CultureInfo.InvariantCulture);
}

/// <summary>The range of an image's finite numbers; infinite and turned around where there are none.</summary>
/// <param name="Least">The least.</param>
/// <param name="Most">The largest.</param>
/// <param name="Top">The number that 99 % stay below, where they are skewed and it is not 0; else the largest.</param>
public sealed record NumberRange(double Least, double Most, double Top);

/// <summary>An auxiliary image of numbers that the film has.</summary>
public abstract record FilmImage : AuxiliaryImage
{
    /// <summary>Reads the numbers of a pixel.</summary>
    public abstract void Read(Film film, int x, int y, Span<double> values);
}
