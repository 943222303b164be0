using System.Collections;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Scenes.Tests;

public class SceneWriterTests
{
    [Fact]
    public void A_scene_reads_back_equal_with_its_names()
    {
        ImageTextureDescription wood = new() { File = "dir/holz \"ü\".png", Wrapping = Wrapping.Mirror, Offset = new(0.1f, -1e-20f) };
        CheckerTextureDescription board = new() { Even = wood, Odd = new SolidTextureDescription { Color = new(0.1f, 1e-30f, 1) } };
        DiffuseMaterialDescription matt = new() { Color = board };
        DiffuseSpecularMaterialDescription coat = new() { Diffuse = matt, Specular = new DielectricMaterialDescription { Extinction = new(1, 2, 3) } };
        DiffuseMaterialDescription plain = new();
        SceneDescription scene = new()
        {
            Camera = new() { Position = new(0.1f, 1 / 3f, 1e10f), FieldOfViewAxis = FieldOfViewAxis.Smaller, Lens = new() { ApertureRadius = 0.25f } },
            Render = new() { Seed = 4294967295, Sampler = SamplerKind.Independent },
            Background = new(0.5f, 0.25f, 0.125f),
            Textures = new Dictionary<string, TextureDescription> { ["wood"] = wood, ["board"] = board, ["grau"] = new SolidTextureDescription { Color = new(0.5f, 0.5f, 0.5f) } },
            Materials = new Dictionary<string, MaterialDescription> { ["coat"] = coat, ["matt"] = matt, ["coat again"] = coat, ["plain"] = plain },
            Shapes =
            [
                new SphereDescription { Center = new(1, 2, 3), Material = coat, Name = "globe" },
                new PlaneDescription { Normal = new(0, 1, 0), Size = new(2, 3), Material = plain },
                new TriangleDescription { B = new(1, 0, 0), C = new(0, 1, 0), UvC = new(5, 5) },
            ],
            Lights = [new SphereDescription { Material = new LuminaireMaterialDescription { Multiplier = 5, Color = wood } }],
        };

        string text = SceneWriter.Write(scene);
        SceneReadResult result = SceneReader.ReadText(text, "written.json");

        Assert.Equal("", Diagnostic.Format(result.Diagnostics));
        AssertEqual(scene, result.Description!, "scene");
        Assert.Same(result.Description!.Materials["coat"], result.Description.Shapes[0].Material);
        Assert.Same(result.Description.Materials["coat"], result.Description.Materials["coat again"]);
        Assert.Same(result.Description.Materials["plain"], result.Description.Shapes[1].Material);
        Assert.Equal(text, SceneWriter.Write(result.Description));
    }

    [Fact]
    public void Scenes_and_descriptions_that_name_no_integrator_mean_path() =>
        Assert.Equal((Integrator.Path, Integrator.Path), (SceneReader.ReadText("{}", "a.json").Description!.Render.Integrator, new SceneDescription().Render.Integrator));

    [Fact]
    public void Defaults_are_left_out() => Assert.Equal("{}\n", SceneWriter.Write(new SceneDescription()).Replace(" ", "", StringComparison.Ordinal));

    [Fact]
    public void Every_type_reads_back_equal_with_all_its_parameters_changed()
    {
        SceneDescription scene = new()
        {
            Materials = SceneTypes.Materials.Types.ToDictionary(t => t.Name, t => (MaterialDescription)Changed(t)),
            Textures = SceneTypes.Textures.Types.ToDictionary(t => t.Name, t => (TextureDescription)Changed(t)),
            Shapes = [.. SceneTypes.Shapes.Types.Select(t => (ShapeDescription)Changed(t))],
        };
        foreach (RecordType environment in SceneTypes.Environments.Types)
        {
            scene = scene with { Environment = (EnvironmentDescription)Changed(environment) };
            SceneReadResult result = SceneReader.ReadText(SceneWriter.Write(scene), "written.json");
            Assert.Equal("", Diagnostic.Format(result.Diagnostics));
            AssertEqual(scene, result.Description!, "scene");
        }
    }

    [Fact]
    public void Numbers_that_JSON_does_not_have_are_refused() =>
        Assert.Throws<ArgumentException>(() => SceneWriter.Write(new SceneDescription { Camera = new() { FieldOfView = float.NaN } }));

    private static object Changed(RecordType type)
    {
        object record = type.Create();
        foreach (RecordParameter parameter in type.Parameters)
        {
            parameter.Set(record, ParameterForm.Of(parameter).Name switch
            {
                "number" => (float)Math.Max(0.7, parameter.Minimum),
                "boolean" => true,
                "text" or "file" => "text",
                "choice" => NamedValues.Of(parameter.ValueType)!.All[1],
                "vector2" => new Vector2(0.3f, 0.4f),
                "vector3" => new Vector3(0.3f, 0.4f, 0.5f),
                "color" => new Rgb(0.3f, 0.4f, 0.5f),
                "texture" when parameter.Minimum > 0 => new SolidTextureDescription { Color = new((float)parameter.Minimum, (float)parameter.Minimum, (float)parameter.Minimum) },
                "texture" => new SolidTextureDescription { Color = new(0.3f, 0.4f, 0.6f) },
                "material" => new DielectricMaterialDescription { RefractiveIndex = 2 },
                "materials" => new MaterialDescription[] { new DielectricMaterialDescription { RefractiveIndex = 3 }, new DiffuseMaterialDescription() },
                "shape" => new SphereDescription { Radius = 2 },
                "shapes" => new ShapeDescription[] { new SphereDescription { Radius = 3 }, new SphereDescription() },
                "records" when parameter.RecordType == typeof(TransformDescription) =>
                    new TransformDescription[] { new() { Matrix = [1, 2.5f], Rotate = 30 }, new() { Scale = new(2, 3, 4) } },
                "records" when parameter.RecordType == typeof(KeyframeDescription) =>
                    new KeyframeDescription[] { new() { Time = 0.5f, Transform = [new() { Translate = new(1, 2, 3) }] }, new() },
                "numbers" => new float[] { 0.1f, -2 },
                "integers" => new int[] { 1, -2 },
                "vector2s" => new Vector2[] { new(0.1f, 2), default },
                "vector3s" => new Vector3[] { new(0.1f, 2, 3), default },
                "triangles" => new TriangleIndices[] { new(1, -2, 3) },
                _ => parameter.Default,
            });
        }

        return record;
    }

    private static void AssertEqual(object? expected, object? actual, string path)
    {
        Assert.True(expected?.GetType() == actual?.GetType() || expected is IEnumerable, $"{path} is a {actual?.GetType()}");
        switch (expected)
        {
            case string or null:
                Assert.True(Equals(expected, actual), path);
                break;
            case IDictionary dictionary:
                Assert.True(dictionary.Keys.Cast<string>().SequenceEqual(((IDictionary)actual!).Keys.Cast<string>()), path);
                Assert.All(dictionary.Keys.Cast<string>(), k => AssertEqual(dictionary[k], ((IDictionary)actual)[k], $"{path}.{k}"));
                break;
            case IEnumerable things:
                object[] others = [.. ((IEnumerable)actual!).Cast<object>()];
                Assert.Equal(things.Cast<object>().Count(), others.Length);
                Assert.All(things.Cast<object>().Zip(others), pair => AssertEqual(pair.First, pair.Second, path));
                break;
            case SceneDescription or CameraDescription or RenderDescription or FilterDescription or TextureDescription or ShapeDescription
                or EnvironmentDescription or TransformDescription or KeyframeDescription:
                Assert.All(RecordType.Of(expected.GetType()).Parameters, p => AssertEqual(p.Get(expected), p.Get(actual!), $"{path}.{p.Key}"));
                break;
            default:
                Assert.True(Equals(expected, actual), $"{path}: {actual} is not {expected}");
                break;
        }
    }
}
