using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Textbook.Tests;

/// <summary>What the textbook edition lacks is refused by name, at its place in the file.</summary>
public class RefusalTests
{
    [Theory]
    [InlineData("""{ "shapes": [ { "type": "cylinder", "bottom": [0, 0, 0], "top": [0, 1, 0] } ] }""", "no shape of type \"cylinder\"", 1, 15)]
    [InlineData("""{ "shapes": [ { "type": "sphere", "center": [0, 0, 0], "material": { "type": "plastic" } } ] }""", "no material of type \"plastic\"", 1, 68)]
    [InlineData("""{ "shapes": [ { "type": "sphere", "center": [0, 0, 0], "material": { "type": "dielectric", "glass": "bk7" } } ] }""", "no \"glass\" of a dielectric", 1, 101)]
    [InlineData("""{ "render": { "integrator": "vcm" } }""", "no integrator \"vcm\"", 1, 29)]
    [InlineData("""{ "render": { "hideLights": true } }""", "no \"hideLights\" of a render", 1, 29)]
    [InlineData("""{ "camera": { "projection": "spherical" } }""", "no spherical cameras", 1, 29)]
    [InlineData("""{ "environment": { "type": "sky" } }""", "no environment of type \"sky\"", 1, 18)]
    [InlineData("""{ "environment": { "type": "image", "file": "a.exr", "mapping": "octahedral" } }""", "no octahedral pictures", 1, 65)]
    [InlineData("""{ "lights": [ { "type": "point", "picture": [1, 1, 1] } ] }""", "no \"picture\" of a point", 1, 45)]
    [InlineData("""{ "shapes": [ { "type": "sphere", "center": [0, 0, 0], "motion": [ { "time": 0 }, { "time": 1, "transform": [ { "translate": [1, 0, 0] } ] } ] } ] }""", "no \"motion\"", 1, 66)]
    public void What_is_lacking_is_refused_at_its_place(string text, string message, int line, int column)
    {
        SceneLoadResult load = SceneLoader.LoadText(text, "test.json", ".");
        SceneReader reader = new(load.LoadPicture, load.LoadModel);
        Assert.Null(reader.Read(load.Description!));
        SceneComplaint complaint = Assert.Single(reader.Complaints);
        Diagnostic diagnostic = load.Locate(complaint);
        Assert.Contains(message, complaint.Message, StringComparison.Ordinal);
        Assert.Equal((line, column), (diagnostic.Line, diagnostic.Column));
    }

    [Fact]
    public void Every_material_shape_and_texture_is_taken_or_refused_by_its_name()
    {
        foreach (MaterialDescription material in Things<MaterialDescription>())
        {
            SceneDescription scene = new() { Shapes = [new Shapes.SphereDescription { Material = material }] };
            SceneReader reader = new();
            bool isTaken = reader.Read(scene) is not null;
            Assert.True(isTaken || reader.Complaints.Any(c => c.Message.Contains('"' + RecordType.Of(material.GetType()).Name + '"', StringComparison.Ordinal)), material.GetType().Name);
        }
    }

    [Fact]
    public void Models_that_move_or_have_looks_to_choose_from_are_refused()
    {
        SceneDescription Showing(Shapes.ModelDescription model) => new() { Shapes = [model] };
        ImportedModel still = new(new() { Shapes = [new Shapes.SphereDescription()] }, []) { Variants = ["red"] };
        string[] Complaints(ImportedModel imported, Shapes.ModelDescription model)
        {
            SceneReader reader = new(loadModel: _ => imported);
            reader.Read(Showing(model));
            return [.. reader.Complaints.Select(c => c.Message)];
        }

        Assert.Empty(Complaints(still, new() { File = "a.glb" }));
        Assert.Contains("has animations", Assert.Single(Complaints(still with { Animations = [new("walk", 1)] }, new() { File = "a.glb" })), StringComparison.Ordinal);
        Assert.Contains("no \"variant\" of a model", Assert.Single(Complaints(still, new() { File = "a.glb", Variant = "red" })), StringComparison.Ordinal);
    }

    [Fact]
    public void Metals_are_those_of_the_scene_format()
    {
        // The same ball by its name and by the numbers that the product's table has.
        string Scene(string metal) => $$"""{ "camera": { "fieldOfView": 5 }, "render": { "width": 2, "height": 2, "samplesPerPixel": 4 }, "background": [1, 1, 1], "shapes": [ { "type": "sphere", "center": [0, 0, 0], "material": { "type": "conductor", {{metal}} } } ] }""";
        foreach (string metal in new[] { "aluminium", "copper", "gold", "silver" })
        {
            SceneLoadResult load = Editions.LoadText(Scene($"\"metal\": \"{metal}\""));
            (ImageSamples textbook, ImageSamples fast) = (Editions.Textbook(load, 2), Editions.Fast(load, 2));
            Assert.All(Enumerable.Range(0, 12), i => Assert.Equal(fast.Value(0, i), textbook.Value(0, i), 1e-4f));
        }
    }

    [Fact]
    public void Samples_do_not_depend_on_those_before_them()
    {
        // A sample depends on the scene, the pixel and its number alone, not on threads or on what was rendered before.
        SceneLoadResult load = Editions.Load(ProjectFolder.PathOf("scenes", "report", "scene2.json"), d => d with { Render = d.Render with { Width = 16, Height = 12, SamplesPerPixel = 4 } });
        Renderer New() => new SceneReader(load.LoadPicture, load.LoadModel).Read(load.Description!)!;
        Rgb[] alone = New().Pass(3, threads: 1);
        Renderer other = New();
        other.Pass(0, threads: 2);
        Assert.Equal(alone, other.Pass(3, threads: 2));
    }

    private static IEnumerable<T> Things<T>() =>
        typeof(T).Assembly.GetTypes().Where(t => t.IsSubclassOf(typeof(T)) && !t.IsAbstract).Select(t => (T)Activator.CreateInstance(t)!);
}
