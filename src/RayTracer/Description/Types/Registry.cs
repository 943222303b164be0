using System.Collections.Immutable;

namespace RayTracer.Description;

/// <summary>The things of one kind that are known by name, whatever its case: the program's, and those of other assemblies.</summary>
/// <param name="kind">The kind's name, for messages.</param>
/// <param name="names">Returns all names of a thing, by any of which it is found.</param>
/// <param name="builtIn">The program's things.</param>
public sealed class Registry<T>(string kind, Func<T, IEnumerable<string>> names, params ReadOnlySpan<T> builtIn) : NamedValues, IRegistry
    where T : class
{
    private ImmutableList<T> _all = [.. builtIn];

    /// <summary>The things: the program's, then others in the order in which they were added.</summary>
    public override IReadOnlyList<T> All => _all;

    /// <inheritdoc/>
    public override IReadOnlyList<string> Names => [.. _all.Select(thing => names(thing).First())];

    /// <summary>Returns the thing of a name; null where there is none.</summary>
    public override T? Find(string name) => Find(_all, name);

    /// <summary>Adds a thing.</summary>
    /// <exception cref="ArgumentException">One of its names is taken.</exception>
    public void Add(T thing) => ImmutableInterlocked.Update(ref _all, With, thing);

    void IRegistry.Check(IEnumerable<object> things)
    {
        ImmutableList<T> all = _all;
        foreach (T thing in things.Cast<T>())
        {
            all = With(all, thing);
        }
    }

    void IRegistry.Add(object thing) => Add((T)thing);

    private ImmutableList<T> With(ImmutableList<T> all, T thing)
    {
        string? taken = names(thing).FirstOrDefault(name => Find(all, name) is not null);
        return taken is null ? all.Add(thing)
            : throw new ArgumentException($"There is another {kind} \"{taken}\": {thing.GetType()} needs another name.", nameof(thing));
    }

    private T? Find(ImmutableList<T> all, string name) => all.Find(thing => names(thing).Contains(name, StringComparer.OrdinalIgnoreCase));
}

/// <summary>A registry, whatever it holds.</summary>
internal interface IRegistry
{
    /// <summary>Refuses things that cannot all be added.</summary>
    /// <exception cref="ArgumentException">A name is taken, or two of them have the same.</exception>
    void Check(IEnumerable<object> things);

    /// <summary>Adds a thing.</summary>
    void Add(object thing);
}
