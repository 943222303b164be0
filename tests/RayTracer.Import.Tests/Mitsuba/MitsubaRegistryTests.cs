using System.Globalization;
using RayTracer.Import;

namespace RayTracer.Import.Tests;

/// <summary>The list of plugins and properties in the documentation, against what the reader itself asks of things.</summary>
public class MitsubaRegistryTests
{
    private const string Heading = "## Plugins and properties\n";

    // Where a thing of each kind stands in a scene; shapes and the like may stand by themselves.
    private static readonly Dictionary<string, string> s_places = new()
    {
        ["shape"] = "{0}",
        ["bsdf"] = "<shape type=\"sphere\">{0}</shape>",
        ["texture"] = "<shape type=\"sphere\"><bsdf type=\"diffuse\">{0}</bsdf></shape>",
        ["spectrum"] = "<shape type=\"sphere\"><bsdf type=\"diffuse\">{0}</bsdf></shape>",
        ["emitter"] = "{0}<shape type=\"sphere\">{0}</shape>",
        ["medium"] = "<shape type=\"sphere\">{0}</shape>",
        ["volume"] = "<shape type=\"sphere\"><medium type=\"heterogeneous\" name=\"interior\">{0}</medium></shape>",
        ["phase"] = "<shape type=\"sphere\"><medium type=\"homogeneous\" name=\"interior\">{0}</medium></shape>",
        ["integrator"] = "{0}",
        ["sensor"] = "{0}",
        ["sampler"] = "<sensor type=\"perspective\">{0}</sensor>",
        ["film"] = "<sensor type=\"perspective\">{0}</sensor>",
        ["rfilter"] = "<sensor type=\"perspective\"><film type=\"hdrfilm\">{0}</film></sensor>",
    };

    private static readonly Dictionary<string, string> s_names = new() { ["texture"] = "reflectance", ["spectrum"] = "reflectance", ["medium"] = "interior", ["volume"] = "sigma_t" };

    [Fact]
    public void The_page_lists_every_plugin_with_its_properties()
    {
        string path = ProjectFolder.PathOf("docs", "mitsuba.md");
        string page = File.ReadAllText(path);
        int begin = page.IndexOf(Heading, StringComparison.Ordinal) + Heading.Length;
        int end = page.IndexOf("\n## ", begin, StringComparison.Ordinal);
        string now = $"{page[..begin]}\n{Table(Registry())}{page[end..]}";
        if (Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1")
        {
            File.WriteAllText(path, now);
        }

        Assert.Equal(now, page);
    }

    [Fact]
    public void Every_kind_has_its_types_and_every_type_its_properties()
    {
        MitsubaRegistry registry = Registry();
        Assert.Equal(s_places.Keys.Order(StringComparer.Ordinal), registry.Types.Keys);
        Assert.Contains("fov", registry.Properties[("emitter", "projector")]);
        Assert.Contains("alpha_u", registry.Properties[("bsdf", "roughconductor")]);
        Assert.All(MitsubaPlugins.Refused.Keys, refused => Assert.DoesNotContain(refused.Type, registry.Types.GetValueOrDefault(refused.Kind) ?? []));
    }

    // One type that nobody has makes the reader list those that there are; then each of them is read.
    private static MitsubaRegistry Registry()
    {
        MitsubaRegistry registry = new();
        MitsubaRegistry.Current = registry;
        try
        {
            using TestScene scene = new();
            foreach ((string kind, string place) in s_places)
            {
                Read("no such type");
                string[] types = [.. registry.Types[kind]];
                Array.ForEach(types, Read);

                void Read(string type)
                {
                    string thing = $"<{kind} type=\"{type}\" name=\"{s_names.GetValueOrDefault(kind)}\"/>";
                    string things = string.Format(CultureInfo.InvariantCulture, place, thing);
                    MitsubaReader.Read(scene.Write("scene.xml", things, place.StartsWith("<sensor", StringComparison.Ordinal) || kind == "sensor" ? "" : TestScene.Sensor));
                }
            }
        }
        finally
        {
            MitsubaRegistry.Current = null;
        }

        return registry;
    }

    private static string Table(MitsubaRegistry registry)
    {
        IEnumerable<string> rows = registry.Types.SelectMany(kind => kind.Value.Select(type => (Kind: kind.Key, Type: type)))
            .GroupBy(thing => (thing.Kind, Properties: string.Join(", ", registry.Properties.GetValueOrDefault((thing.Kind, thing.Type)) ?? [])))
            .Select(same => $"| {same.Key.Kind} | {string.Join(", ", same.Select(t => t.Type))} | {same.Key.Properties} |\n");
        return "| kind | type | properties, and names of things within |\n|---|---|---|\n" + string.Concat(rows);
    }
}
