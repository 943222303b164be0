using System.Diagnostics.CodeAnalysis;
using RayTracer.Description;
using RayTracer.Scenes;
using static RayTracer.Import.ModelCheck;

namespace RayTracer.Import;

/// <summary>Reads whole model files.</summary>
internal static class ModelBytes
{
    /// <summary>The content of a file.</summary>
    /// <exception cref="ModelException">There is no such file, it is not an ordinary one, or it has more than 2 GiB.</exception>
    /// <exception cref="IOException">It cannot be opened.</exception>
    public static byte[] Read(string path)
    {
        if (FileSearch.Complaint(path) is { } complaint)
        {
            throw new ModelException(complaint);
        }

        using var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 1);
        Require(stream.Length <= Array.MaxLength, $"it has {stream.Length} bytes, and models can have at most 2 GiB");

        string? tooMuch = SceneBudget.Open?.Take($"a file of {stream.Length} bytes", 0, stream.Length);
        Require(tooMuch is null, tooMuch ?? "");
        byte[] content = GC.AllocateUninitializedArray<byte>((int)stream.Length);
        stream.ReadExactly(content);
        return content;
    }
}

/// <summary>
/// How much a model may make the importer allocate: ten times its files and a fixed amount. Counts in a file are not
/// trusted, and a few bytes can ask for gigabytes.
/// </summary>
internal sealed class ModelMemory
{
    /// <summary>The memory that every model may use, in bytes, however small its files are.</summary>
    public const long Always = 192L << 20;

    /// <summary>The multiple of the size of its files that a model may use beyond that.</summary>
    public const int TimesFiles = 8;

    private long _files;
    private long _used;

    /// <summary>Counts a file of the model.</summary>
    public void AddFile(long bytes) => _files += bytes;

    /// <summary>Asks for memory before it is allocated.</summary>
    /// <returns>True if it is granted.</returns>
    public bool TryUse(long bytes)
    {
        if (bytes > Always + (TimesFiles * _files) - _used)
        {
            return false;
        }

        _used += bytes;
        return true;
    }
}

/// <summary>Refuses files.</summary>
internal static class ModelCheck
{
    /// <summary>Refuses a file in which something does not hold.</summary>
    /// <exception cref="ModelException">The condition is false.</exception>
    public static void Require([DoesNotReturnIf(false)] bool condition, string otherwise)
    {
        if (!condition)
        {
            throw new ModelException(otherwise);
        }
    }

    /// <summary>Returns the value of a key, which is made when it is first asked for.</summary>
    public static TValue Remember<TKey, TValue>(this Dictionary<TKey, TValue> known, TKey key, Func<TValue> make)
        where TKey : notnull
    {
        if (!known.TryGetValue(key, out TValue? value))
        {
            value = make();
            known.Add(key, value);
        }

        return value;
    }
}
