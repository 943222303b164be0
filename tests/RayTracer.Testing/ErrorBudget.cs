namespace RayTracer.Testing;

/// <summary>
/// How the suite's probability of a false alarm is shared out. All statistical tests, in all test projects, fail through one
/// of these families; so by Bonferroni's inequality the whole suite fails by chance with a probability below the sum of
/// their shares. A family belongs to one test project, for its p-values are counted a process.
/// </summary>
public static class ErrorBudget
{
    /// <summary>Upper bound of the probability that any test fails though nothing is wrong.</summary>
    public const double Whole = 1e-3;

    /// <summary>Product against oracle, scene by scene.</summary>
    public static TestFamily Oracle { get; } = new("oracle", 1.5e-4, 200, "product and oracle have the same expected image");

    /// <summary>Product against the images of another renderer.</summary>
    public static TestFamily References { get; } = new("references", 1.5e-4, 60, "product and reference have the same expected image");

    /// <summary>Maps from the unit square against their pdfs.</summary>
    public static TestFamily Warps { get; } = new("warps", 5e-5, 500, "samples are distributed by the pdf");

    /// <summary>Sampling of lights against their pdfs.</summary>
    public static TestFamily Lights { get; } = new("lights", 5e-5, 1000, "light samples are distributed by the pdf");

    /// <summary>Sampling of materials against their pdfs.</summary>
    public static TestFamily Materials { get; } = new("materials", 1e-4, 5000, "scattered directions are distributed by the pdf");

    /// <summary>Points of samplers.</summary>
    public static TestFamily Samplers { get; } = new("samplers", 1e-4, 2000, "points are uniform, uncorrelated and converge as theory says");

    /// <summary>Renders against closed forms.</summary>
    public static TestFamily Analytic { get; } = new("analytic", 1e-4, 1000, "the expected image is the closed form");

    /// <summary>Properties of geometry that hold in distribution only.</summary>
    public static TestFamily Geometry { get; } = new("geometry", 5e-5, 100, "equivalent scenes have the same expected image");

    /// <summary>Integrators against one another.</summary>
    public static TestFamily Transport { get; } = new("transport", 5e-5, 200, "integrators have the same expected image");

    /// <summary>The tests of the tests: p-values under the null hypothesis.</summary>
    public static TestFamily NullRuns { get; } = new("null runs", 1e-4, 200, "p-values below a are no more frequent than a");

    /// <summary>The assertions of images for others' use.</summary>
    public static TestFamily Images { get; } = new("images", 5e-5, 50, "two sets of images have the same expectation");

    /// <summary>Pixel filters, images of edges through them, and noise.</summary>
    public static TestFamily Filters { get; } = new("filters", 2e-5, 200, "samples are spread as the filter's curve, edges as its integral, and noise about zero");

    /// <summary>Scenes with features two by two, against equal ones that are made otherwise.</summary>
    public static TestFamily Pairs { get; } = new("pairs", 2e-5, 40, "equal scenes that are made otherwise have the same expected image");

    /// <summary>The edition to be read, against the renderer and against closed forms.</summary>
    public static TestFamily Textbook { get; } = new("textbook", 9e-6, 200, "both editions have the same expected image, and what the textbook one samples has its pdf");

    /// <summary>All families.</summary>
    public static IReadOnlyList<TestFamily> Families { get; } =
        [Oracle, References, Warps, Lights, Materials, Samplers, Analytic, Geometry, Transport, NullRuns, Images, Filters, Pairs, Textbook];
}
