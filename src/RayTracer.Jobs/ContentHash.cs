using System.Collections;
using System.Globalization;
using System.Reflection;
using System.Security.Cryptography;
using System.Text;
using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Jobs;

/// <summary>
/// The hash of all that decides what a sample comes to: the description with every value that is not as it is without being given (for the integrator: not the report's), the
/// content of every file that it names, the part that
/// is rendered, and for each kind of thing in the scene the version of its bits. Where files lie, what they are called and how scenes are
/// written does not count.
/// </summary>
public class ContentHash : IDisposable
{
    private readonly IncrementalHash _hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
    private readonly Dictionary<object, int> _seen = new(ReferenceEqualityComparer.Instance);
    private readonly string _folder;

    private protected ContentHash(string folder) => _folder = folder;

    /// <summary>Computes it.</summary>
    /// <param name="scene">The scene as it is rendered.</param>
    /// <param name="path">The scene's file; others are looked for from its folder.</param>
    /// <param name="crop">The part that is rendered; null for all.</param>
    public static string Of(SceneDescription scene, string path, Tile? crop)
    {
        using ContentHash hash = new(Path.GetDirectoryName(path) ?? "");
        hash.Text($"{crop}");
        foreach (BitVersion version in BitVersions.Of(scene))
        {
            hash.Text($"{version.Name} {version.Version}");
        }

        return hash.Of(scene);
    }

    /// <summary>The hash of all that decides on a picture, with all its samples.</summary>
    /// <param name="scene">The scene as it is rendered.</param>
    /// <param name="path">The scene's file; others are looked for from its folder.</param>
    /// <param name="crop">The part that is rendered; null for all.</param>
    public static string OfPicture(SceneDescription scene, string path, Tile? crop) =>
        string.Create(CultureInfo.InvariantCulture, $"{Of(scene, path, crop)}-{scene.Render.SamplesPerPixel}{Tone(scene.Render)}");

    /// <inheritdoc/>
    public void Dispose()
    {
        _hash.Dispose();
        GC.SuppressFinalize(this);
    }

    /// <summary>The hash of what was added, and a scene.</summary>
    private protected string Of(SceneDescription scene)
    {
        Add(scene with { Animation = [], Render = scene.Render with { SamplesPerPixel = scene.Render.Sampler.DependsOnCount ? scene.Render.SamplesPerPixel : 1 } });
        return Convert.ToHexStringLower(_hash.GetHashAndReset());
    }

    /// <summary>Returns true for a value that counts: one that is as it is without being given has no effect.</summary>
    private protected virtual bool Counts(RecordParameter parameter, object? value) => value switch
    {
        null => false,
        ICollection things => things.Count > 0,
        _ => !value.Equals(Absent(parameter)) || !Parts(value).SequenceEqual(Parts(Absent(parameter))),
    };

    /// <summary>Ends a record, some of whose values may not count.</summary>
    private protected virtual void EndRecord() => Text("end");

    // What hashes leave out never changes, so that films of scenes that say the same go together: of integrators that is the report's,
    // which was the default when hashes were first made.
    private static object Absent(RecordParameter parameter) =>
        parameter.ValueType == typeof(Integrator) ? Integrator.Report : parameter.Default!;

    // The film does not depend on it.
    private static bool IsOfDisplay(RecordParameter parameter) =>
        parameter.ValueType == typeof(ToneMap) || parameter.ValueType == typeof(Exposure);

    // Nothing for light as it is, as pictures of the scenes that were shown so have it.
    internal static string Tone(RenderDescription render) =>
        (render.ShownToneMap, render.ShownExposure) == (ToneMap.Clamp, default) ? "" : $"-{render.ShownToneMap}-{render.ShownExposure}";

    // Equal numbers may have other bits: 0 and −0.
    private static IEnumerable<string> Parts(object value) => value switch
    {
        IFormattable number and not Enum => [number.ToString(null, CultureInfo.InvariantCulture)],
        ValueType and not Enum and not bool => Fields(value).SelectMany(Parts),
        _ => [],
    };

    // Small values such as colours.
    private static IEnumerable<object> Fields(object value) =>
        value.GetType().GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic).Select(f => f.GetValue(value)!);

    private void Add(object? value)
    {
        switch (value)
        {
            case null:
                Text("-");
                break;
            case string text:
                Text(text);
                break;
            case NamedValue { Name: var name }:
                Text(char.ToUpperInvariant(name[0]) + name[1..] + OfOrigin(value.GetType()));
                break;
            case IFormattable number and not Enum:
                Text(number.ToString(null, CultureInfo.InvariantCulture));
                break;
            case Enum or bool:
                Text($"{value}");
                break;
            case IDictionary named:
                AddNamed(named);
                break;
            case IEnumerable things:
                object?[] all = [.. things.Cast<object?>()];
                Text($"list {all.Length}");
                Array.ForEach(all, Add);
                break;
            default:
                AddRecord(value);
                break;
        }
    }

    // Plug-ins of another version may do something else by the same names.
    private static string OfOrigin(Type type) => Plugins.OriginOf(type) is { } origin ? $" of {origin}" : "";

    private void AddNamed(IDictionary named)
    {
        Text($"named {named.Count}");
        foreach (DictionaryEntry entry in named)
        {
            Text((string)entry.Key);
            Add(entry.Value);
        }
    }

    private void AddRecord(object record)
    {
        if (record.GetType().IsValueType)
        {
            foreach (object field in Fields(record))
            {
                Add(field);
            }

            return;
        }

        if (!_seen.TryAdd(record, _seen.Count))
        {
            Text($"again {_seen[record]}");
            return;
        }

        RecordType type = RecordType.Of(record.GetType());
        Text($"record {type.Name}{OfOrigin(record.GetType())}");
        foreach (RecordParameter parameter in type.Parameters)
        {
            object? value = parameter.Get(record);
            if (IsOfDisplay(parameter) || !Counts(parameter, value))
            {
                continue;
            }

            Text(parameter.Key);
            if (parameter.IsFile && value is string { Length: > 0 } file)
            {
                AddFile(Path.GetFullPath(Path.Combine(_folder, file)));
            }
            else if (value is not null && ParameterForm.Of(parameter).Content(value) is (var count, var bytes))
            {
                Text($"numbers {count}");
                _hash.AppendData(bytes);
            }
            else
            {
                Add(value);
            }
        }

        EndRecord();
    }

    private void AddFile(string path)
    {
        string folder = Path.GetDirectoryName(path)!;
        foreach (string file in ModelSidecars.Everywhere(path).Select(n => Path.Combine(folder, n)).Prepend(path).Where(File.Exists))
        {
            using FileStream stream = File.OpenRead(file);
            Text(Convert.ToHexStringLower(SHA256.HashData(stream)));
        }
    }

    // With its length before it, so that no two sequences of texts are the same bytes.
    private protected void Text(string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        _hash.AppendData(BitConverter.GetBytes(bytes.Length));
        _hash.AppendData(bytes);
    }
}
