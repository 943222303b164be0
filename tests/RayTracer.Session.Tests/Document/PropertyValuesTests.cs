using System.Globalization;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Scenes;
using RayTracer.Session;
using JsonNode = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Session.Tests;

/// <summary>What panels show and set, for every parameter that there is.</summary>
public sealed class PropertyValuesTests
{
    public static TheoryData<string> Types => [.. SceneTypes.Families.SelectMany(f => f.Types.Select(t => $"{f.Noun} {t.Name}"))];

    [Theory]
    [MemberData(nameof(Types))]
    public void Every_parameter_of_a_type_is_shown_with_its_default_and_can_be_set_and_reset(string familyAndType)
    {
        string[] words = familyAndType.Split(' ');
        TypeFamily family = SceneTypes.Families.First(f => f.Noun == words[0]);
        RecordType type = family.Find(words[1])!;
        string pointer = words[0] switch { "shape" => "/shapes/0", "environment" => "/environment", _ => $"/{words[0]}s/thing" };
        JsonText bare = JsonText.Of("{\n  // head\n  \"shapes\": [],\n}").Set(words[0] == "shape" ? "/shapes/-" : pointer, new JsonObject { ["type"] = type.Name });
        PropertyValues values = PropertyValues.At(bare.Root, pointer);
        Assert.Equal((type.Name, family.Noun), (values.Type, values.Family));
        Assert.Equal(type.Parameters.Select(p => p.Key), values.Effective.Keys);
        foreach (RecordParameter parameter in type.Parameters)
        {
            JsonNode value = Example(parameter);
            JsonText set = bare.Set($"{pointer}/{parameter.Key}", value);
            Assert.True(JsonNode.DeepEquals(value, PropertyValues.At(set.Root, pointer).Effective[parameter.Key]), parameter.Key);
            Assert.DoesNotContain(SceneReader.ReadText(set.Text, "").Diagnostics, d => d.Message.Contains($"\"{parameter.Key}\"", StringComparison.Ordinal) && !d.Message.Contains(" needs ", StringComparison.Ordinal));
            Assert.Equal(bare.Text, set.Remove($"{pointer}/{parameter.Key}").Text);
            if (parameter.Default is { } standard)
            {
                Assert.Equal(SceneWriter.WriteValue(parameter, standard), JsonLayout.OneLine(values.Effective[parameter.Key]));
            }
        }
    }

    [Fact]
    public void Sections_that_are_not_written_are_shown_and_made_when_something_in_them_is_set()
    {
        JsonText text = JsonText.Of("{\n  \"shapes\": []\n}");
        PropertyValues lens = PropertyValues.At(text.Root, "/camera/lens");
        Assert.Equal(("lens", null, -1), (lens.Type, lens.Value, lens.From));
        Assert.Equal("0", lens.Effective["apertureRadius"]!.ToJsonString());
        text = text.Set("/camera/lens/apertureRadius", JsonValue.Create(0.5));
        Assert.Equal("{\n  \"shapes\": [],\n  \"camera\": { \"lens\": { \"apertureRadius\": 0.5 } }\n}", text.Text);
    }

    [Fact]
    public void The_catalogue_has_all_types_and_parameters_and_says_what_the_report_says_of_glass()
    {
        TypeCatalogue catalogue = TypeCatalogue.Instance;
        Assert.Equal(["shape", "material", "texture", "environment"], catalogue.Types.Keys);
        Assert.Equal(SceneTypes.Families.Sum(f => f.Types.Sum(t => t.Parameters.Count)), catalogue.Types.Values.Sum(f => f.Sum(t => t.Parameters.Count)));
        Assert.All(["scene", "camera", "lens", "render"], name => Assert.Contains(name, catalogue.Sections.Keys));
        Assert.Equal(2.417, catalogue.RefractiveIndices.Single(i => i.Name == "diamond").Value);
        Assert.Equal("#87ceeb", catalogue.Colors["skyblue"]);
    }

    [SkippableFact]
    public void Table_4_1_is_the_reports()
    {
        Skip.If(ProjectFolder.Shared("report", "report.txt") is null, "the report is not beside the project");
        string table = File.ReadLines(ProjectFolder.Shared("report", "report.txt")!).Single(l => l.Contains("Material Refraction value", StringComparison.Ordinal)).ToLowerInvariant().Replace("cloride", "chloride", StringComparison.Ordinal);
        foreach (RefractiveIndex index in RefractiveIndex.All)
        {
            string name = index.Name.Split(" (")[0];
            Assert.Contains(index.Value.ToString(CultureInfo.InvariantCulture), table[table.IndexOf(name, StringComparison.Ordinal)..].Split(name)[1], StringComparison.Ordinal);
        }
    }

    private static JsonNode Example(RecordParameter parameter) => ParameterForm.Of(parameter).Name switch
    {
        "number" => JsonValue.Create(Inside(parameter)),
        "integer" => JsonValue.Create((int)Math.Max(1, Inside(parameter))),
        "boolean" => JsonValue.Create(parameter.Default is not true),
        "text" or "file" => JsonValue.Create("a \"quoted\" \\ name\t"),
        "choice" => JsonValue.Create(parameter.Choices[^1]),
        "vector2" => new JsonArray(0.25, 0.5),
        "vector3" or "color" => new JsonArray(0.25, 0.5, 0.75),
        "texture" when parameter.Minimum > 0 => JsonValue.Create(Inside(parameter)),
        "texture" => JsonValue.Create("skyblue"),
        "material" => JsonNode.Parse("""{ "type": "diffuse" }""")!,
        "materials" => JsonNode.Parse("""[{ "type": "diffuse" }]""")!,
        "shape" => JsonNode.Parse("""{ "type": "sphere", "center": [0, 0, 0] }""")!,
        "shapes" => JsonNode.Parse("""[{ "type": "sphere", "center": [0, 0, 0] }]""")!,
        "record" when parameter.RecordType == typeof(MediumDescription) => JsonNode.Parse("""{ "extinction": [1, 2, 3] }""")!,
        "record" when parameter.RecordType == typeof(RayTracer.Shapes.PlaybackDescription) => JsonNode.Parse("""{ "speed": 2 }""")!,
        "record" when parameter.RecordType == typeof(RayTracer.Shapes.RefinementDescription) => JsonNode.Parse("""{ "subdivide": 2 }""")!,
        "records" when parameter.RecordType == typeof(KeyframeDescription) => JsonNode.Parse("""[{ "time": 1 }]""")!,
        "records" => JsonNode.Parse("""[{ "translate": [1, 2, 3] }]""")!,
        "numbers" => new JsonArray(1, 2.5),
        "integers" => new JsonArray(1, 2),
        "vector2s" => JsonNode.Parse("[[1, 2.5]]")!,
        "vector3s" => JsonNode.Parse("[[1, 2.5, 3]]")!,
        "triangles" => JsonNode.Parse("[[0, 1, 2]]")!,
        _ => throw new NotSupportedException(ParameterForm.Of(parameter).Name),
    };

    private static double Inside(RecordParameter parameter) =>
        double.IsFinite(parameter.Maximum) && double.IsFinite(parameter.Minimum) ? (parameter.Minimum + parameter.Maximum) / 2 : double.IsFinite(parameter.Minimum) ? parameter.Minimum + 0.5 : 0.5;
}
