using System.Collections.Immutable;
using System.Reflection;

namespace RayTracer.Description;

/// <summary>
/// Makes things of other assemblies known: descriptions of shapes, materials, textures and environments with a <see cref="SceneTypeAttribute"/>,
/// and classes derived from one that has a <see cref="Registry{T}"/> called <c>Known</c>, such as <see cref="Rendering.AuxiliaryImage"/>.
/// </summary>
public static class Plugins
{
    private static readonly Lock s_gate = new();
    private static ImmutableList<Assembly> s_added = [];

    /// <summary>The assemblies that were added.</summary>
    public static IReadOnlyList<Assembly> Added => s_added;

    /// <summary>Adds all that an assembly defines, or nothing, before the first scene is read or built. Any thread may do so.</summary>
    /// <param name="assembly">The assembly. Of its public classes, all that have a constructor without arguments are looked at.</param>
    /// <exception cref="PluginException">It has nothing to add, a name is taken, or it was made for another version of the
    /// core.</exception>
    public static void Add(Assembly assembly)
    {
        lock (s_gate)
        {
            CheckVersion(assembly);
            Type[] types = [.. assembly.GetExportedTypes().Where(t => t is { IsClass: true, IsAbstract: false } && t.GetConstructor([]) is not null)];
            (TypeFamily Family, RecordType Type)[] records =
                [.. types.SelectMany(t => SceneTypes.Families.Where(f => f.Holds(t)).Select(f => (f, Made(t, RecordType.Of))))];
            (IRegistry Registry, object Thing)[] things =
                [.. types.Where(t => RegistryOf(t) is not null).Select(t => (RegistryOf(t)!, Made(t, type => Activator.CreateInstance(type)!)))];
            CheckNames(assembly, records, things);
            Array.ForEach(things, t => t.Registry.Add(t.Thing));
            Array.ForEach(records, r => r.Family.Add(r.Type));
            s_added = s_added.Add(assembly);
        }
    }

    /// <summary>Returns the name and version of the added assembly that a type is of; null where it is of none.</summary>
    /// <param name="type">The type of a record or of a thing in a registry.</param>
    public static string? OriginOf(Type type) =>
        s_added.Contains(type.Assembly) && type.Assembly.GetName() is var name ? $"{name.Name} {name.Version}" : null;

    private static void CheckVersion(Assembly assembly)
    {
        AssemblyName core = typeof(Plugins).Assembly.GetName();
        if (Array.Find(assembly.GetReferencedAssemblies(), r => r.Name == core.Name) is { } used && used.Version != core.Version)
        {
            throw new PluginException($"{assembly.GetName().Name} was made for version {used.Version} of {core.Name}, but this is {core.Version}: build it again");
        }
    }

    // All names, before the first thing is added.
    private static void CheckNames(Assembly assembly, (TypeFamily Family, RecordType Type)[] records, (IRegistry Registry, object Thing)[] things)
    {
        string? name = assembly.GetName().Name;
        if (records.Length + things.Length == 0)
        {
            throw new PluginException($"{name} has no types for scenes: it needs public records with [SceneType], or classes that a registry takes");
        }

        foreach ((TypeFamily family, RecordType type) in records)
        {
            if (family.Find(type.Name) is not null || records.Count(r => r.Family == family && r.Type.Name == type.Name) > 1)
            {
                throw new PluginException($"the {family.Noun} {Quotation.Of(type.Name)} of {name} needs another name: there is one already");
            }
        }

        foreach (IGrouping<IRegistry, object> group in things.GroupBy(t => t.Registry, t => t.Thing))
        {
            try
            {
                group.Key.Check(group);
            }
            catch (ArgumentException e)
            {
                throw new PluginException($"{name}: {e.Message}", e);
            }
        }
    }

    // The registry of a base class, whichever assembly that is in.
    private static IRegistry? RegistryOf(Type type)
    {
        for (Type? ancestor = type.BaseType; ancestor is not null; ancestor = ancestor.BaseType)
        {
            if (ancestor.GetProperty("Known", BindingFlags.Public | BindingFlags.Static | BindingFlags.DeclaredOnly) is { } known
                && known.PropertyType == typeof(Registry<>).MakeGenericType(ancestor))
            {
                return (IRegistry?)known.GetValue(null);
            }
        }

        return null;
    }

    // What the constructor of a plug-in refuses is the plug-in's fault.
    private static T Made<T>(Type type, Func<Type, T> make)
    {
        try
        {
            return make(type);
        }
        catch (TargetInvocationException e)
        {
            throw new PluginException($"{type.FullName}: {e.InnerException!.Message}", e);
        }
    }
}

/// <summary>An assembly whose things cannot be added; the message says why, for the user.</summary>
public sealed class PluginException : Exception
{
    /// <summary>Says what is wrong.</summary>
    public PluginException(string message) : base(message)
    {
    }

    /// <summary>Says what is wrong, and what caused it.</summary>
    public PluginException(string message, Exception innerException) : base(message, innerException)
    {
    }

    /// <summary>An unnamed fault.</summary>
    public PluginException()
    {
    }
}
