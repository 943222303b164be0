using System.Text.RegularExpressions;

namespace RayTracer.Repository.Tests.Documentation;

public sealed partial class ReportPageTests
{
    private const long MostPictureBytes = 1_500_000;
    private static readonly Lazy<HashSet<string>> s_types = new(() =>
        [.. Directory.EnumerateFiles(ProjectFolder.PathOf("src"), "*.cs", SearchOption.AllDirectories)
            .SelectMany(path => Declaration().Matches(File.ReadAllText(path))).Select(m => m.Groups[1].Value)]);

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
        // LinksTests sees to anchors.
        string[] links = [.. Link().Matches(Text).Select(m => m.Groups[1].Value.Split('#')[0]).Where(l => l.Length > 0)];
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

    [Theory]
    [InlineData("1.3 light from an environment map", "ImageEnvironment")]
    [InlineData("1.2 adaptive supersampling", "SamplePlanner")]
    [InlineData("1.2 ray packets, SIMD", "Wavefront")]
    [InlineData("1.2 spatial structures", "TriangleBvh")]
    [InlineData("9 ease of use", "CommandLine")]
    [InlineData("9 pruning", "ShapeTree")]
    [InlineData("9 single precision, SIMD", "FloatW")]
    [InlineData("3.3.4 local coordinate system, affine transformations", "Transform")]
    [InlineData("3.4 motion blur", "Motion")]
    [InlineData("3.5 bounding boxes, BVH", "TriangleBvh")]
    [InlineData("3.5 k-d tree, quadtree, octree, BSP tree, oriented boxes as bounds", "KdTree")]
    [InlineData("3.5 k-d tree, quadtree, octree, BSP tree, oriented boxes as bounds", "Quadtree")]
    [InlineData("3.5 k-d tree, quadtree, octree, BSP tree, oriented boxes as bounds", "Octree")]
    [InlineData("3.5 k-d tree, quadtree, octree, BSP tree, oriented boxes as bounds", "BspTree")]
    [InlineData("3.5 k-d tree, quadtree, octree, BSP tree, oriented boxes as bounds", "OrientedBoxes")]
    [InlineData("4.1 light, 4.1.1 colour and spectra", "Wavelengths")]
    [InlineData("4.2.3 index by wavelength (figure 4.8)", "Dispersion")]
    [InlineData("4.3.1 parallelogram light", "Rectangle")]
    [InlineData("6.1 torus, cylinder", "Torus")]
    [InlineData("6.1 instancing by matrices", "InstanceTree")]
    [InlineData("6.1 uniform subdivision", "UniformGrid")]
    [InlineData("`RayTracerForm`", "StudioServer")]
    public void What_exists_is_named_and_not_denied(string part, string type)
    {
        Assert.True(s_types.Value.Contains(type), $"{type}, which docs/report.md names for “{part}”, is no type of src any more");
        string row = Assert.Single(Text.Split('\n'), line => line.StartsWith($"| {part} |", StringComparison.Ordinal));
        string answer = row[$"| {part} |".Length..];
        Assert.True(Regex.IsMatch(answer, $@"\b{type}\b") && !answer.TrimStart().StartsWith("None", StringComparison.Ordinal),
            $"docs/report.md says of “{part}”:{answer}, and there is {type}");
    }

    [Fact]
    public void Each_part_that_is_denied_is_one_of_those_that_are_checked()
    {
        string[] denied = [.. Text.Split('\n').Where(line => line.StartsWith('|') && line.Contains("| None", StringComparison.Ordinal)).Select(line => line.Split('|')[1].Trim())];
        Assert.Equal(["1.1 the entertainment industry", "7 interview, appendix"], denied);
    }

    [Fact]
    public void Pictures_are_small()
    {
        FileInfo[] pictures = new DirectoryInfo(ProjectFolder.PathOf("docs", "pictures", "report")).GetFiles();
        Assert.InRange(pictures.Sum(f => f.Length), 1, MostPictureBytes);
    }

    [GeneratedRegex(@"\b(?:class|struct|record|interface|enum)\s+(?:struct\s+)?([A-Z]\w*)")]
    private static partial Regex Declaration();

    [GeneratedRegex(@"`((?:src|tests|docs|scenes)/[^`\s]+)`")]
    private static partial Regex RepositoryPath();

    [GeneratedRegex(@"\]\(([^)\s]+)\)")]
    private static partial Regex Link();
}
