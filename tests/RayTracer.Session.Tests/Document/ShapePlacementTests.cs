using System.Globalization;
using System.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>Shapes that are moved in the text stand where they were moved to, in numbers of their own where that is possible.</summary>
[Trait("Category", "Thorough")]
public sealed class ShapePlacementTests
{
    private static readonly Dictionary<string, string> s_shapes = new(StringComparer.Ordinal)
    {
        ["sphere"] = "\"center\": [0.1, 0.2, 0], \"radius\": 0.5",
        ["box"] = "\"a\": [-0.4, -0.3, -0.2], \"b\": [0.4, 0.3, 0.5]",
        ["cylinder"] = "\"bottom\": [0, -0.4, 0], \"top\": [0.2, 0.5, 0.1], \"radius\": 0.3",
        ["cone"] = "\"bottom\": [0, -0.4, 0], \"top\": [0.2, 0.5, 0.1], \"radius\": 0.4, \"topRadius\": 0.1",
        ["torus"] = "\"center\": [0, 0.1, 0], \"axis\": [1, 2, 1], \"radius\": 0.4, \"tubeRadius\": 0.15",
        ["disk"] = "\"center\": [0, 0.1, 0], \"normal\": [0.5, 1, 2], \"radius\": 0.5",
        ["rectangle"] = "\"corner\": [-0.4, -0.4, 0], \"edgeU\": [0.9, 0.1, 0], \"edgeV\": [0, 0.8, 0.2]",
        ["triangle"] = "\"a\": [-0.5, -0.4, 0], \"b\": [0.5, -0.3, 0.1], \"c\": [0, 0.6, 0]",
        ["plane"] = "\"point\": [0, 0.1, 0], \"normal\": [0.3, 0.2, 1], \"size\": [1, 0.8]",
        ["mesh"] = "\"positions\": [[-0.5, -0.4, 0], [0.5, -0.3, 0.1], [0, 0.6, 0]], \"triangles\": [[0, 1, 2]]",
        ["group"] = "\"shapes\": [{ \"type\": \"sphere\", \"center\": [0.2, 0.1, 0], \"radius\": 0.3 }, { \"type\": \"box\", \"a\": [-0.5, -0.5, 0], \"b\": [-0.1, 0.1, 0.3] }]",
        ["instance"] = "\"of\": { \"type\": \"sphere\", \"center\": [0.2, 0.1, 0], \"radius\": 0.3 }",
    };

    public static TheoryData<string, bool> Kinds
    {
        get
        {
            TheoryData<string, bool> kinds = [];
            foreach (string kind in s_shapes.Keys)
            {
                kinds.Add(kind, false);
                kinds.Add(kind, true);
            }

            return kinds;
        }
    }

    [Theory]
    [InlineData("sphere", "translate 1 2 3", "{ \"type\": \"sphere\", \"center\": [1.1, 2.2, 3], \"radius\": 0.5 }")]
    [InlineData("sphere", "scale 2 2 2", "{ \"type\": \"sphere\", \"center\": [0.1, 0.2, 0], \"radius\": 1 }")]
    [InlineData("sphere", "scale 2 1 1", "{ \"type\": \"sphere\", \"center\": [0.1, 0.2, 0], \"radius\": 0.5, \"transform\": [{ \"scale\": [2, 1, 1], \"translate\": [-0.1, 0, 0] }] }")]
    [InlineData("box", "scale 2 1 1", "{ \"type\": \"box\", \"a\": [-0.8, -0.3, -0.2], \"b\": [0.8, 0.3, 0.5] }")]
    [InlineData("box", "rotate 0 1 0 30", "{ \"type\": \"box\", \"a\": [-0.4, -0.3, -0.2], \"b\": [0.4, 0.3, 0.5], \"transform\": [{ \"rotate\": 30, \"translate\": [-0.07500, 0, 0.02009619] }] }")]
    [InlineData("triangle", "translate 0 1 0", "{ \"type\": \"triangle\", \"a\": [-0.5, 0.6, 0], \"b\": [0.5, 0.7, 0.1], \"c\": [0, 1.6, 0] }")]
    [InlineData("disk", "translate 0 1 0", "{ \"type\": \"disk\", \"center\": [0, 1.1, 0], \"normal\": [0.5, 1, 2], \"radius\": 0.5 }")]
    [InlineData("mesh", "translate 0 1 0", "{ \"type\": \"mesh\", \"positions\": [[-0.5, -0.4, 0], [0.5, -0.3, 0.1], [0, 0.6, 0]], \"triangles\": [[0, 1, 2]], \"transform\": [{ \"translate\": [0, 1, 0] }] }")]
    public void Known_movements_give_known_numbers(string kind, string movement, string expected)
    {
        JsonText moved = Apply(JsonText.Of(Scene(Shape(kind))), "/shapes/0", movement);
        string actual = JsonValues.Of(moved.At("/shapes/0"))!.ToJsonString();
        double[] numbers = Numbers(actual);
        Assert.Equal(WithoutNumbers(JsonValues.Of(JsonText.Of(expected).Root)!.ToJsonString()), WithoutNumbers(actual));
        Assert.All(Numbers(expected).Zip(numbers), pair => Assert.Equal(pair.First, pair.Second, 2e-6));
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_moved_shape_looks_as_the_shape_in_a_moved_group(string kind, bool isWithin)
    {
        Random random = new(TestSettings.Seed + kind.Length);
        int seen = 0;
        for (int i = 0; i < TestSettings.Scale(3, 20); i++)
        {
            string[] movements = [.. Enumerable.Range(0, 3).Select(_ => RandomMovement(random))];
            string outer = isWithin ? ", \"transform\": [{ \"scale\": [-0.8, 0.8, 0.8], \"rotate\": 40, \"axis\": [1, 1, 0], \"translate\": [0.2, 0, 0] }]" : "";
            string pointer = isWithin ? "/shapes/0/shapes/0" : "/shapes/0";
            string Around(string shape) => Scene(isWithin ? $"{{ \"type\": \"group\", \"shapes\": [{shape}]{outer} }}" : shape);
            JsonText moved = JsonText.Of(Around(Shape(kind)));
            foreach (string movement in movements)
            {
                moved = Apply(moved, pointer, movement + " about 0.1 0 0.05");
            }

            string inner = isWithin ? $"{{ \"type\": \"group\", \"shapes\": [{Shape(kind)}]{outer} }}" : Shape(kind);
            string expected = Scene($"{{ \"type\": \"group\", \"shapes\": [{inner}], \"transform\": [{string.Join(", ", movements.Select(Steps))}] }}");
            seen += AssertSameLook(expected, moved.Text, $"{kind}: {string.Join("; ", movements)}");
        }

        Assert.True(seen > 20, $"only {seen} pixels show it");
    }

    [Fact]
    public void What_moves_in_time_moves_as_before_at_another_place()
    {
        const string Motion = "\"center\": [0, 0, 0], \"radius\": 0.3, \"motion\": [{ \"time\": 0, \"transform\": [{ \"rotate\": 20, \"axis\": [0, 0, 1] }, { \"translate\": [0.2, 0, 0] }] }, { \"time\": 1, \"transform\": [{ \"translate\": [0, 0.4, 0] }] }]";
        string ball = $"{{ \"type\": \"sphere\", {Motion} }}";
        JsonText moved = Apply(Apply(JsonText.Of(Scene(ball)), "/shapes/0", "rotate 0 0 1 35 about 0.1 0 0.05"), "/shapes/0", "translate 0.1 -0.2 0");
        Assert.Contains("\"center\": [0, 0, 0]", moved.Text, StringComparison.Ordinal);
        AssertSameLook(Scene($"{{ \"type\": \"group\", \"shapes\": [{ball}], \"transform\": [{Steps("rotate 0 0 1 35")}, {{ \"translate\": [0.1, -0.2, 0] }}] }}"), moved.Text, "motion");
    }

    [Fact]
    public void Textured_shapes_keep_their_texture_by_a_transform()
    {
        const string Globe = "{ \"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 0.6, \"material\": \"m\" }";
        string Textured(string shape) => Scene(shape).Replace("\"background\":", "\"materials\": { \"m\": { \"type\": \"diffuse\", \"color\": { \"type\": \"checker\", \"scale\": [8, 4] } } }, \"background\":", StringComparison.Ordinal);
        JsonText moved = Apply(JsonText.Of(Textured(Globe)), "/shapes/0", "rotate 0 0 1 70 about 0.1 0 0.05");
        Assert.Contains("\"transform\"", moved.Text, StringComparison.Ordinal);
        AssertSameLook(Textured($"{{ \"type\": \"group\", \"shapes\": [{Globe}], \"transform\": [{Steps("rotate 0 0 1 70")}] }}"), moved.Text, "texture");
        Assert.DoesNotContain("\"transform\"", Apply(JsonText.Of(Textured(Globe)), "/shapes/0", "translate 1 0 0").Text, StringComparison.Ordinal);
    }

    [Fact]
    public void A_drag_changes_one_step_and_ends_where_it_ends()
    {
        JsonText text = JsonText.Of(Scene(Shape("mesh")));
        for (int i = 0; i < 100; i++)
        {
            text = ShapePlacement.Translate(text, "/shapes/0", new(0.01f, 0, 0));
            text = ShapePlacement.Rotate(text, "/shapes/0", i % 2 == 0 ? Vector3.UnitY : -Vector3.UnitY, i % 2 == 0 ? 1 : -1, Vector3.Zero);
        }

        Assert.Single(text.At("/shapes/0/transform").Items);
        Assert.Equal(100, SceneValue.At(text.Root, "/shapes/0/transform/0")!.Number("rotate"), 1e-3);
    }

    [Theory]
    [InlineData("scale 0 1 1")]
    [InlineData("rotate 0 0 0 10")]
    [InlineData("translate 1e38 1e38 1e38")]
    [InlineData("scale 1e-30 1e-30 1e-30")]
    public void Movements_that_cannot_be_computed_with_are_refused(string movement) =>
        Assert.Throws<SessionException>(() => Apply(JsonText.Of(Scene(Shape("sphere"))), "/shapes/0", movement));

    private static string Shape(string kind) => $"{{ \"type\": \"{kind}\", {s_shapes[kind]} }}";

    private static string Scene(string shape) =>
        $"{{ \"camera\": {{ \"position\": [0.5, 0.8, 4] }}, \"render\": {{ \"width\": 40, \"height\": 40, \"samplesPerPixel\": 4, \"shutter\": [0, 0.5], \"maxDiffuseDepth\": 0 }}, "
        + $"\"background\": [0.1, 0.2, 0.3], \"shapes\": [{shape}], \"lights\": [{{ \"type\": \"sphere\", \"center\": [2, 3, 3], \"radius\": 0.5, \"material\": {{ \"type\": \"luminaire\", \"multiplier\": 30 }} }}] }}";

    private static string RandomMovement(Random random)
    {
        string Number(double low, double high) => (low + (random.NextDouble() * (high - low))).ToString("F3", CultureInfo.InvariantCulture);
        return random.Next(4) switch
        {
            0 => $"translate {Number(-0.4, 0.4)} {Number(-0.4, 0.4)} {Number(-0.4, 0.4)}",
            1 => $"rotate {Number(-1, 1)} {Number(0.1, 1)} {Number(-1, 1)} {Number(-180, 180)}",
            2 => Number(0.6, 1.4) is var s ? $"scale {s} {s} {s}" : "",
            _ => $"scale {Number(0.6, 1.4)} {Number(0.6, 1.4)} {Number(0.6, 1.4)}",
        };
    }

    private static JsonText Apply(JsonText text, string pointer, string movement)
    {
        string[] parts = movement.Split(" about ");
        float[] n = [.. parts[0].Split(' ').Skip(1).Select(w => float.Parse(w, CultureInfo.InvariantCulture))];
        Vector3? center = parts.Length > 1 ? new Vector3([.. parts[1].Split(' ').Select(w => float.Parse(w, CultureInfo.InvariantCulture))]) : null;
        Vector3 v = new(n[0], n[1], n[2]);
        return movement[0] switch
        {
            't' => ShapePlacement.Translate(text, pointer, v),
            'r' => ShapePlacement.Rotate(text, pointer, v, n[3], center),
            _ => ShapePlacement.Scale(text, pointer, v, center),
        };
    }

    // As steps of a transform, about the point (0.1, 0, 0.05).
    private static string Steps(string movement)
    {
        string[] n = movement.Split(' ');
        string vector = $"[{n[1]}, {n[2]}, {n[3]}]";
        return n[0] switch
        {
            "translate" => $"{{ \"translate\": {vector} }}",
            "rotate" => $"{{ \"translate\": [-0.1, 0, -0.05] }}, {{ \"rotate\": {n[4]}, \"axis\": {vector} }}, {{ \"translate\": [0.1, 0, 0.05] }}",
            _ => $"{{ \"translate\": [-0.1, 0, -0.05] }}, {{ \"scale\": {vector} }}, {{ \"translate\": [0.1, 0, 0.05] }}",
        };
    }

    // But for pixels at edges, where a rounding decides what is hit. Returns how many pixels show anything.
    private static int AssertSameLook(string expected, string actual, string what)
    {
        (Film a, Film b) = (Render(expected), Render(actual));
        int different = 0;
        int seen = 0;
        for (int i = 0; i < a.Width * a.Height; i++)
        {
            (int x, int y) = (i % a.Width, i / a.Width);
            different += Math.Abs(a.Mean(x, y).G - b.Mean(x, y).G) > 0.02 ? 1 : 0;
            seen += Math.Abs(a.Mean(x, y).G - 0.2) > 1e-3 ? 1 : 0;
        }

        Assert.True(different <= 4, $"{what}: {different} pixels differ: {actual}");
        return seen;
    }

    private static Film Render(string text)
    {
        SceneLoadResult load = SceneLoader.Build(SceneReader.ReadText(text, "scene"), "");
        Assert.True(load.Scene is not null, $"{Diagnostic.Format(load.Diagnostics)}\n{text}");
        return new RTracer(load.Scene, new RenderOptions { Threads = 1 }).Render().Film;
    }

    private static double[] Numbers(string json) => [.. System.Text.RegularExpressions.Regex.Matches(json, "-?[0-9.]+(E-?[0-9]+)?", System.Text.RegularExpressions.RegexOptions.None, TimeSpan.FromSeconds(5))
        .Select(m => double.Parse(m.Value, CultureInfo.InvariantCulture))];

    private static string WithoutNumbers(string json) =>
        System.Text.RegularExpressions.Regex.Replace(json, "-?[0-9.]+(E-?[0-9]+)?", "#", System.Text.RegularExpressions.RegexOptions.None, TimeSpan.FromSeconds(5));
}
