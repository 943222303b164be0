using System.Text.RegularExpressions;

namespace RayTracer.Repository.Tests.Documentation;

public sealed partial class ReportPageTests
{
    private const long MostPictureBytes = 1_500_000;
    private static readonly string Text = File.ReadAllText(ProjectFolder.PathOf("docs", "report.md"));

    [Fact]
    public void Every_path_that_is_mentioned_exists()
    {
        string[] paths = [.. RepositoryPath().Matches(Text).Select(m => m.Groups[1].Value).Distinct()];
        Assert.True(paths.Length > 50, $"only {paths.Length} paths were found");
        Assert.All(paths, p => Assert.True(File.Exists(ProjectFolder.PathOf(p)), p));
    }

    [Fact]
    public void Every_link_leads_to_a_file()
    {
        string[] links = [.. Link().Matches(Text).Select(m => m.Groups[1].Value)];
        Assert.True(links.Length > 10, $"only {links.Length} links were found");
        Assert.All(links, l => Assert.True(File.Exists(ProjectFolder.PathOf("docs", l)), l));
    }

    [Fact]
    public void Every_listing_and_class_of_the_report_is_mapped()
    {
        string[] names =
        [
            "RTracer", "Scene", "Camera", "Ray", "HitRecord", "ONB", "RGB", "Vector3", "Shape", "Sphere", "Plane", "Triangle",
            "Material", "DiffuseMaterial", "DiffuseSpecularMaterial", "PhongMetalMaterial", "DielectricMaterial",
            "LuminaireMaterial", "Texture", "SolidTexture", "ImageTexture", "Picture", "FastBitmap", "RayTracerForm",
        ];
        Assert.All(names, n => Assert.Contains($"`{n}`", Text, StringComparison.Ordinal));
        Assert.All(["6.1", "6.2", "6.3", "6.4"], n => Assert.Contains($"| Listing {n} ", Text, StringComparison.Ordinal));
    }

    [Fact]
    public void Pictures_are_small()
    {
        FileInfo[] pictures = new DirectoryInfo(ProjectFolder.PathOf("docs", "pictures", "report")).GetFiles();
        Assert.InRange(pictures.Sum(f => f.Length), 1, MostPictureBytes);
    }

    [GeneratedRegex(@"`((?:src|tests|docs|scenes)/[^`\s]+)`")]
    private static partial Regex RepositoryPath();

    [GeneratedRegex(@"\]\(([^)\s]+)\)")]
    private static partial Regex Link();
}
