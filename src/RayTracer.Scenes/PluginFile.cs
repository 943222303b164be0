using System.Reflection;
using System.Runtime.Loader;
using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Loads other people's assemblies, whose types scene files may then name. A scene file itself can name none.</summary>
public static class PluginFile
{
    /// <summary>The option of the programs that names such files.</summary>
    public const string Option = "--plugin";

    /// <summary>Loads an assembly and adds what it defines, before the first scene is read. What else it needs is looked for in its folder.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="PluginException">It cannot be loaded, or <see cref="Plugins.Add"/> refuses it.</exception>
    public static void Load(string path) => Read(path, assembly =>
    {
        Plugins.Add(assembly);
        Array.ForEach([.. SceneTypes.All.SelectMany(t => t.Parameters)], p => ParameterForm.Of(p));
    });

    /// <summary>Loads an assembly without adding what it defines.</summary>
    /// <param name="path">The file.</param>
    /// <param name="use">Is given the assembly.</param>
    /// <exception cref="PluginException">It cannot be loaded.</exception>
    public static void Read(string path, Action<Assembly> use)
    {
        try
        {
            _ = AssemblyName.GetAssemblyName(path);
            use(new Context(Path.GetFullPath(path)).Itself);
        }
        catch (PluginException e)
        {
            throw new PluginException($"{path}: {e.Message}", e);
        }
        catch (NotSupportedException e)
        {
            throw new PluginException($"{path}: {e.Message.TrimEnd('.')}", e);
        }
        catch (BadImageFormatException e)
        {
            throw new PluginException($"{path}: this is no .NET assembly", e);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or TypeLoadException or System.Security.SecurityException)
        {
            throw new PluginException($"{path}: cannot be loaded: {e.Message.TrimEnd('.')}", e);
        }
    }

    /// <summary>Loads the files that the options among a program's arguments name.</summary>
    /// <returns>The other arguments.</returns>
    /// <exception cref="PluginException">As for <see cref="Load"/>.</exception>
    public static string[] LoadAll(string[] args)
    {
        List<string> others = [];
        int end = Array.IndexOf(args, "--") is >= 0 and int dashes ? dashes : args.Length;
        for (int i = 0; i < args.Length; i++)
        {
            if (i < end && args[i].StartsWith(Option + "=", StringComparison.Ordinal))
            {
                Load(args[i][(Option.Length + 1)..]);
            }
            else if (i + 1 < end && args[i] == Option)
            {
                Load(args[++i]);
            }
            else
            {
                others.Add(args[i]);
            }
        }

        return [.. others];
    }

    // The program's own assemblies are shared: types of a plug-in are derived from the program's.
    private sealed class Context : AssemblyLoadContext
    {
        private readonly AssemblyDependencyResolver _resolver;

        public Context(string path) : base(path)
        {
            _resolver = new(path);
            Itself = LoadFromAssemblyPath(path);
        }

        public Assembly Itself { get; }

        protected override Assembly? Load(AssemblyName assemblyName)
        {
            try
            {
                return Default.LoadFromAssemblyName(assemblyName);
            }
            catch (IOException)
            {
                return _resolver.ResolveAssemblyToPath(assemblyName) is { } path ? LoadFromAssemblyPath(path) : null;
            }
        }
    }
}
