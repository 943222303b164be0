using System.Numerics;
using System.Reflection;
using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Text.Json.Serialization;
using RayTracer.Numerics;
using RayTracer.Session;

namespace RayTracer.Studio.Tests;

/// <summary>The page's types (<c>api/types.ts</c>) are made from the records that the server sends and takes.</summary>
public sealed class PageTypesTests
{
    private const string Head = """
        /** What the server sends and takes: written from its records by the tests, where RAYTRACER_UPDATE is 1. */

        export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
        export type Vec3 = [number, number, number];

        """;

    private static readonly Type[] s_sent =
    [
        typeof(StudioState), typeof(Outline), typeof(TypeCatalogue), typeof(PropertyValues), typeof(PickResult), typeof(PixelMask), typeof(PixelReading), typeof(PictureComparison), typeof(ComparisonMap), typeof(GizmoHandles), typeof(LightBody), typeof(LightDrag),
        typeof(HandleDrag), typeof(InspectedPixel), typeof(PixelSummary), typeof(TreeWalk), typeof(WireframeView), typeof(Convergence), typeof(FolderListing), typeof(MeasuredTimes), typeof(PictureFormat), typeof(TimelineRows), typeof(KeyChoice), typeof(MotionPaths), typeof(HelpIndex), typeof(HelpPage), typeof(HelpFindings),
    ];

    private readonly NullabilityInfoContext _nullability = new();
    private readonly SortedDictionary<string, string> _definitions = new(StringComparer.Ordinal);

    [Fact]
    public void The_types_of_the_page_are_those_of_the_servers_records()
    {
        foreach (Type type in s_sent)
        {
            Define(type);
        }

        RepositoryFolder.AssertHolds(
            ProjectFolder.PathOf("src", "RayTracer.Studio", "frontend", "src", "api", "types.ts"),
            Head.ReplaceLineEndings("\n") + string.Concat(_definitions.Values.Select(d => "\n" + d)));
    }

    private string Define(Type type)
    {
        if (_definitions.TryAdd(type.Name, ""))
        {
            _definitions[type.Name] = type.IsEnum
                ? $"export type {type.Name} = {string.Join(" | ", Enum.GetNames(type).Select(n => $"\"{Camel(n)}\""))};\n"
                : Interface(type);
        }

        return type.Name;
    }

    private string Interface(Type type)
    {
        StringBuilder text = new($"export interface {type.Name} {{\n");
        foreach (PropertyInfo property in type.GetProperties(BindingFlags.Public | BindingFlags.Instance).Where(p => p.GetCustomAttribute<JsonIgnoreAttribute>() is null))
        {
            text.Append($"  {Camel(property.Name)}: {TypeOf(_nullability.Create(property))};\n");
        }

        return text.Append("}\n").ToString();
    }

    private string TypeOf(NullabilityInfo info)
    {
        string name = NameOf(info);
        return info.ReadState == NullabilityState.Nullable && name != "Json" ? $"{name} | null" : name;
    }

    private string NameOf(NullabilityInfo info)
    {
        Type type = Nullable.GetUnderlyingType(info.Type) ?? info.Type;
        return type switch
        {
            { IsEnum: true } => Define(type),
            _ when type == typeof(string) || type == typeof(DateTime) => "string",
            _ when type == typeof(bool) => "boolean",
            _ when type == typeof(JsonNode) => "Json",
            _ when type == typeof(Vector2) => "[number, number]",
            _ when type == typeof(Vector3) || type == typeof(Rgb) => "Vec3",
            { IsPrimitive: true } => "number",
            { IsArray: true } => ListOf(TypeOf(info.ElementType!)),
            { IsGenericType: true } when type.GetGenericTypeDefinition() == typeof(IReadOnlyList<>) => ListOf(TypeOf(info.GenericTypeArguments[0])),
            { IsGenericType: true } when type.GetGenericTypeDefinition() == typeof(IReadOnlyDictionary<,>) => $"Record<string, {TypeOf(info.GenericTypeArguments[1])}>",
            _ => Define(type),
        };
    }

    private static string ListOf(string element) => element.Contains(' ', StringComparison.Ordinal) && !element.StartsWith('[') ? $"({element})[]" : $"{element}[]";

    private static string Camel(string name) => JsonNamingPolicy.CamelCase.ConvertName(name);
}
