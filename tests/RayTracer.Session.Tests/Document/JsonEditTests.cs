using System.Text.Json.Nodes;
using RayTracer.Scenes;
using RayTracer.Session;
using JsonNode = RayTracer.Scenes.JsonNode;

namespace RayTracer.Session.Tests;

/// <summary>Edits of a text by pointer: what they write where, and that they write nowhere else.</summary>
[Trait("Category", "Thorough")]
public sealed class JsonEditTests
{
    public static TheoryData<string> Scenes => ShippedScenes.All;

    [Theory]
    [InlineData("{}", "/a", "1", "{\n  \"a\": 1\n}")]
    [InlineData("""{ "a": { } }""", "/a/b", "1", """{ "a": { "b": 1 } }""")]
    [InlineData("""{ "a": 1 }""", "/b", "2", """{ "a": 1, "b": 2 }""")]
    [InlineData("""{ "a": 1, }""", "/b", "2", """{ "a": 1, "b": 2, }""")]
    [InlineData("""{ "a": 1 /* one */ }""", "/b", "2", """{ "a": 1, "b": 2 /* one */ }""")]
    [InlineData("{\n    \"a\": 1 // one\n}", "/b", "2", "{\n    \"a\": 1, // one\n    \"b\": 2\n}")]
    [InlineData("{\n    \"a\": 1, // one\n}", "/b", "2", "{\n    \"a\": 1, // one\n    \"b\": 2,\n}")]
    [InlineData("{\n\t\"a\": {}\n}", "/a/b/c", "[1, 2]", "{\n\t\"a\": { \"b\": { \"c\": [1, 2] } }\n}")]
    [InlineData("{\n  // nothing yet\n}", "/a", "1", "{\n  // nothing yet\n  \"a\": 1\n}")]
    [InlineData("{\n  \"a\": [\n  ]\n}", "/a/-", "1", "{\n  \"a\": [\n    1\n  ]\n}")]
    [InlineData("""{ "a": [1, 2] }""", "/a/-", "3", """{ "a": [1, 2, 3] }""")]
    [InlineData("""{ "a": [1, 2,] }""", "/a/2", "3", """{ "a": [1, 2, 3,] }""")]
    [InlineData("""{ "a": [1, /* two */ 2] }""", "/a/0", "\"x\"", """{ "a": ["x", /* two */ 2] }""")]
    [InlineData("""{ "a/b~c": 1 }""", "/a~1b~0c", "2", """{ "a/b~c": 2 }""")]
    public void Set_follows_the_style_around_it(string before, string pointer, string value, string after) =>
        Assert.Equal(after, JsonText.Of(before).Set(pointer, System.Text.Json.Nodes.JsonNode.Parse(value)).Text);

    [Theory]
    [InlineData("""{ "a": 1 }""", "/a", "{}")]
    [InlineData("""{ "a": 1, "b": 2 }""", "/a", """{ "b": 2 }""")]
    [InlineData("""{ "a": 1, "b": 2 }""", "/b", """{ "a": 1 }""")]
    [InlineData("""{ "a": 1, "b": 2, }""", "/b", """{ "a": 1, }""")]
    [InlineData("""{ "a": 1 /* one */, /* two */ "b": 2 }""", "/b", """{ "a": 1 /* one */ /* two */ }""")]
    [InlineData("{\n  \"a\": 1, // one\n  \"b\": 2 // two\n}", "/b", "{\n  \"a\": 1 // one\n}")]
    [InlineData("{\n  \"a\": 1, // one\n  \"b\": 2, // two\n}", "/a", "{\n  \"b\": 2, // two\n}")]
    [InlineData("{\n  \"a\": 1, \"b\": 2,\n  \"c\": 3,\n}", "/b", "{\n  \"a\": 1,\n  \"c\": 3,\n}")]
    [InlineData("{\n  \"a\": 1, // one\n  \"b\": 2 }", "/b", "{\n  \"a\": 1 // one\n }")]
    [InlineData("[[1, 2, 3], 4]", "/0/1", "[[1, 3], 4]")]
    [InlineData("[\n  1,\n  // two\n  2,\n]", "/0", "[\n  // two\n  2,\n]")]
    public void Remove_takes_the_comma_and_what_is_its_own(string before, string pointer, string after) =>
        Assert.Equal(after, JsonText.Of(before).Remove(pointer).Text);

    [Theory]
    [InlineData("{\n  \"a\": 1, // one\n  \"b\": 2\n}", "/a", "c", "{\n  \"a\": 1, // one\n  \"c\": 1,\n  \"b\": 2\n}")]
    [InlineData("""{ "a": { "x": 1 } }""", "/a", "b", """{ "a": { "x": 1 }, "b": { "x": 1 } }""")]
    [InlineData("[[1 /* one */],\n [2]]", "/0", "", "[[1 /* one */], [1 /* one */],\n [2]]")]
    public void Duplicate_copies_what_is_written(string before, string pointer, string key, string after) =>
        Assert.Equal(after, JsonText.Of(before).Duplicate(pointer, key).Text.Text);

    [Fact]
    public void What_does_not_fit_on_a_line_is_laid_out_in_the_units_of_the_text()
    {
        JsonArray rows = new([.. Enumerable.Range(0, 12).Select(i => (System.Text.Json.Nodes.JsonNode)new JsonArray(i, i + 0.5, -i))]);
        string text = JsonText.Of("{\n\t\"shapes\": [\n\t\t{ \"type\": \"mesh\" }\n\t]\n}").Set("/shapes/0/positions", rows).Text;
        Assert.Contains("\n\t\t\t[11, 11.5, -11]\n\t\t]", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("/shapes/3")]
    [InlineData("/camera/1/position")]
    [InlineData("/shapes/01")]
    [InlineData("shapes")]
    public void Places_that_cannot_be_are_refused_in_a_sentence(string pointer)
    {
        JsonText text = JsonText.Of("""{ "camera": [], "shapes": [1, 2] }""");
        Assert.Throws<SessionException>(() => text.Set(pointer, JsonValue.Create(1)));
        Assert.Throws<SessionException>(() => text.Remove(pointer));
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void A_walk_of_random_edits_changes_only_what_it_is_about(string path)
    {
        Random random = new(TestSettings.Seed + path.Length);
        JsonText text = JsonText.Of(ShippedScenes.Text(path));
        for (int i = 0; i < TestSettings.Scale(30, 300); i++)
        {
            string[] pointers = [.. Pointers(text.Root, "").Where(p => p.Length > 0)];
            if (pointers.Length == 0)
            {
                break;
            }

            string pointer = pointers[random.Next(pointers.Length)];
            JsonText before = text;
            JsonNode node = before.At(pointer);
            string container = JsonPointer.Parent(pointer)!;
            Dictionary<string, string?> others = Values(before.Root).Where(v => !Touches(v.Key, pointer, container)).ToDictionary();
            bool isElement = before.At(container).Kind == JsonKind.Array;
            bool countsOn = false;
            switch (random.Next(4))
            {
                case 0:
                    text = before.Set(pointer, JsonValue.Create(random.Next(100)));
                    string written = text.Text[text.At(pointer).Start..text.At(pointer).End];
                    Assert.Equal(before.Text[..node.Start] + written + before.Text[node.End..], text.Text);
                    break;
                case 1:
                    text = before.Remove(pointer);
                    countsOn = isElement;
                    Assert.True(IsSubsequence(text.Text, before.Text));
                    break;
                case 2:
                    (text, string copy) = before.Duplicate(pointer, $"new {i}");
                    countsOn = isElement;
                    Assert.True(IsSubsequence(before.Text, text.Text));
                    Assert.Equal(Plain(node), Plain(text.At(copy)));
                    break;
                default:
                    string key = isElement ? "-" : $"key {i}";
                    text = before.Set(JsonPointer.Append(container, key), new JsonObject { ["x"] = i });
                    Assert.True(IsSubsequence(before.Text, text.Text));
                    break;
            }

            Assert.Equal(Comments(before.Text).Where(c => text.Text.Contains(c, StringComparison.Ordinal)).Count(), Comments(text.Text).Count(c => before.Text.Contains(c, StringComparison.Ordinal)));
            foreach ((string other, string? value) in countsOn ? others.Where(o => !o.Key.StartsWith(container + "/", StringComparison.Ordinal)) : others)
            {
                Assert.Equal(value, Plain(text.At(other)));
            }
        }
    }

    internal static IEnumerable<string> Pointers(JsonNode node, string pointer) => node.Items.SelectMany((item, i) => Pointers(item, JsonPointer.Append(pointer, i)))
        .Concat(node.Members.SelectMany(m => Pointers(m.Value, JsonPointer.Append(pointer, m.Key))))
        .Prepend(pointer);

    private static IEnumerable<KeyValuePair<string, string?>> Values(JsonNode root) => Pointers(root, "")
        .Select(p => (Pointer: p, Node: JsonPointer.Find(root, p)!))
        .Where(v => v.Node.Items.Count + v.Node.Members.Count == 0)
        .Select(v => KeyValuePair.Create(v.Pointer, Plain(v.Node)));

    private static bool Touches(string other, string pointer, string container) =>
        other == container || other == pointer || other.StartsWith(pointer + "/", StringComparison.Ordinal);

    private static string? Plain(JsonNode node) => JsonValues.Of(node)?.ToJsonString();

    private static IEnumerable<string> Comments(string text) =>
        System.Text.RegularExpressions.Regex.Matches(text, "//[^\n]*", System.Text.RegularExpressions.RegexOptions.None, TimeSpan.FromSeconds(10)).Select(m => m.Value).Distinct();

    private static bool IsSubsequence(string part, string whole)
    {
        int at = 0;
        foreach (char c in whole)
        {
            at += at < part.Length && part[at] == c ? 1 : 0;
        }

        return at == part.Length;
    }
}
