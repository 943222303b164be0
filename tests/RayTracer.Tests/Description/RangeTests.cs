using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;
using RayTracer.Textures;
using Xunit;

namespace RayTracer.Tests.Description;

/// <summary>Covers <see cref="RangeCheck"/>, <see cref="SceneException"/> and <see cref="Scene.From"/>.</summary>
public class RangeTests
{
    public static TheoryData<SceneDescription, string> Wrong => new()
    {
        { Ball(radius: -1), "SphereDescription \"ball\", Radius: \"radius\" must be greater than 0, but is -1" },
        { Ball(radius: float.NaN), "SphereDescription \"ball\", Radius: \"radius\" must be greater than 0, but is NaN" },
        { Ball(radius: float.PositiveInfinity), "SphereDescription \"ball\", Radius: \"radius\" must be greater than 0, but is Infinity" },
        { Of(new DiffuseMaterialDescription { Color = Solid(5) }), "DiffuseMaterialDescription, Color: \"color\" must be from 0 to 1, but is 5" },
        { Of(new DielectricMaterialDescription { RefractiveIndex = -3 }), "DielectricMaterialDescription, RefractiveIndex: \"refractiveIndex\" must be from 0.001 to 100, but is -3" },
        { With(new TorusDescription { TubeRadius = -0.5f }), "TorusDescription, TubeRadius: \"tubeRadius\" must be greater than 0, but is -0.5" },
        { With(new SphereDescription { Material = null! }), "SphereDescription, Material: \"material\" must not be null" },
        { With(null!), "SceneDescription, Shapes: \"shapes\" must not hold null" },
        { With(new SphereDescription { Center = new(0, float.NaN, 0) }), "SphereDescription, Center: \"center\" must be a finite number, but is NaN" },
        { new() { Camera = new() { Lens = new() { Blades = 2 } } }, "LensDescription, Blades: \"blades\" must be from 3 to 64, but is 2" },
        { new() { Camera = new() { Window = [0, 0, 1, 2] } }, "CameraDescription, Window: \"window\" must be from 0 to 1, but is 2" },
        { new() { Render = new() { Width = 0 } }, "RenderDescription, Width: \"width\" must be from 1 to 65536, but is 0" },
        { new() { Background = new(-1, 0, 0) }, "SceneDescription, Background: \"background\" must be at least 0, but is -1" },
        {
            new() { Materials = new Dictionary<string, MaterialDescription> { ["unused"] = new DiffuseMaterialDescription { Color = Solid(-1) } } },
            "DiffuseMaterialDescription, Color: \"color\" must be from 0 to 1, but is -1"
        },
        {
            With(new GroupDescription { Shapes = [new InstanceDescription { Of = new SphereDescription { Radius = 0 } }] }),
            "SphereDescription, Radius: \"radius\" must be greater than 0, but is 0"
        },
        {
            Of(new MixMaterialDescription { First = new DiffuseMaterialDescription { Color = new CheckerTextureDescription { Odd = Solid(7) } } }),
            "DiffuseMaterialDescription, Color: \"color\" must be from 0 to 1, but is 7"
        },
    };

    [Theory]
    [MemberData(nameof(Wrong))]
    public void Values_out_of_range_are_refused_with_their_names_whatever_they_are_within(SceneDescription scene, string message) =>
        Assert.Equal(message, Assert.Throws<SceneException>(() => Scene.From(scene)).Message);

    [Fact]
    public void All_that_is_wrong_is_said_at_once_and_shared_records_once()
    {
        DiffuseMaterialDescription shining = new() { Color = Solid(5) };
        SceneDescription scene = new()
        {
            Render = new() { SamplesPerPixel = 0 },
            Shapes = [new SphereDescription { Radius = -1, Material = shining }, new SphereDescription { Material = shining }],
        };

        SceneException refusal = Assert.Throws<SceneException>(() => Scene.From(scene));

        Assert.Equal(["SamplesPerPixel", "Radius", "Color"], refusal.Complaints.Select(c => c.Property));
        Assert.All(refusal.Complaints, c => Assert.True(c.IsOutOfRange));
    }

    [Fact]
    public void Materials_of_programs_are_checked_though_they_cannot_be_made_without_arguments() => Assert.Equal(
        "PaintDescription, Gloss: \"gloss\" must be from 0 to 1, but is 2",
        Assert.Throws<SceneException>(() => Scene.From(Of(new PaintDescription("red") { Gloss = 2 }))).Message);

    [Fact]
    public void Models_that_programs_read_are_checked_and_complaints_are_about_what_names_them()
    {
        ModelDescription model = new() { File = "a.model" };

        SceneException refusal = Assert.Throws<SceneException>(() => Scene.From(With(model), null, _ => new(Ball(-1), [])));

        SceneComplaint complaint = Assert.Single(refusal.Complaints);
        Assert.Same(model, complaint.Subject);
        Assert.Equal("a sphere in the file: \"radius\" must be greater than 0, but is -1", complaint.Message);
    }

    [Fact]
    public void Views_of_a_scene_are_checked_as_scenes_are()
    {
        Scene scene = Scene.From(Ball(1));
        SceneBuilder builder = new();

        Assert.Null(scene.WithView(new(), scene.Render with { MaxDepth = -2 }, builder));

        Assert.Equal(nameof(RenderDescription.MaxDepth), Assert.Single(builder.Complaints).Property);
    }

    [Fact]
    public void Colours_and_numbers_stand_for_textures_and_films_give_pixels_and_pictures()
    {
        SceneDescription scene = Of(new DiffuseMaterialDescription { Color = new Rgb(1, 0.5f, 0) }) with { Background = new(0.25f, 0.5f, 1) };
        (Film film, _) = new RTracer(Scene.From(scene)).Render();
        Assert.Equal(new(0.25f, 0.5f, 1), film[0, 0]);
        Assert.Equal([.. Enumerable.Range(0, 16).SelectMany(i => new[] { film[i % 4, i / 4].R, film[i % 4, i / 4].G, film[i % 4, i / 4].B })], film.ToPicture().Pixels);
        TextureDescription half = 0.5f;
        Assert.Equal(Solid(0.5f), half);
    }

    [Fact]
    public void Groups_that_hold_themselves_are_refused_and_do_not_keep_the_check_going()
    {
        List<ShapeDescription> shapes = [];
        GroupDescription group = new() { Shapes = shapes };
        shapes.Add(group);

        Assert.Contains("nested too deep", Assert.Throws<SceneException>(() => Scene.From(With(group))).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void What_a_new_record_holds_is_in_range() =>
        Assert.All(SceneTypes.Parts.Concat(SceneTypes.Families.SelectMany(f => f.Types)), type =>
            Assert.All(type.Parameters.Where(p => !p.Required), p => Assert.Null(p.RangeComplaint(p.Default))));

    private static SceneDescription Ball(float radius) => With(new SphereDescription { Name = "ball", Radius = radius });

    private static SceneDescription Of(MaterialDescription material) => With(new SphereDescription { Material = material });

    private static SceneDescription With(ShapeDescription shape) => new() { Render = new() { Width = 4, Height = 4 }, Shapes = [shape] };

    private static SolidTextureDescription Solid(float grey) => new() { Color = new(grey, grey, grey) };

    private sealed record PaintDescription(string Colour) : MaterialDescription
    {
        [Parameter("How much of the light is reflected.", Minimum = 0, Maximum = 1)]
        public float Gloss { get; init; }

        public override Material Build(SceneBuilder builder) => builder.Material(new DiffuseMaterialDescription());
    }
}
