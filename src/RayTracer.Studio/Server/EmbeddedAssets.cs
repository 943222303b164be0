using System.Collections.Frozen;
using System.Reflection;
using System.Security.Cryptography;
using System.Text.RegularExpressions;
using Microsoft.AspNetCore.StaticFiles;

namespace RayTracer.Studio;

/// <summary>
/// The pages, which are within the program. They are found by their exact names only: there is no path that could lead elsewhere.
/// </summary>
internal sealed partial class EmbeddedAssets
{
    private const string Prefix = "wwwroot/";
    private const string Start = "/index.html";

    private readonly FrozenDictionary<string, Asset> _assets;

    /// <summary>Reads the table.</summary>
    public EmbeddedAssets()
    {
        Assembly assembly = typeof(EmbeddedAssets).Assembly;
        _assets = assembly.GetManifestResourceNames()
            .Where(name => name.StartsWith(Prefix, StringComparison.Ordinal))
            .ToFrozenDictionary(name => name[(Prefix.Length - 1)..].Replace('\\', '/'), name => Asset.Read(assembly, name), StringComparer.Ordinal);
    }

    /// <summary>Answers a request for a page.</summary>
    public Task Serve(HttpContext context)
    {
        (HttpRequest request, HttpResponse response) = (context.Request, context.Response);
        if (!HttpMethods.IsGet(request.Method) && !HttpMethods.IsHead(request.Method))
        {
            response.StatusCode = StatusCodes.Status405MethodNotAllowed;
            return Task.CompletedTask;
        }

        string path = request.Path.Value is null or "" or "/" ? Start : request.Path.Value;
        if (!_assets.TryGetValue(path, out Asset? asset))
        {
            response.StatusCode = StatusCodes.Status404NotFound;
            return Task.CompletedTask;
        }

        response.ContentType = asset.Type;
        response.Headers.ETag = asset.Tag;
        response.Headers.CacheControl = asset.IsHashed ? "public, max-age=31536000, immutable" : "no-cache";
        if (request.Headers.IfNoneMatch == asset.Tag)
        {
            response.StatusCode = StatusCodes.Status304NotModified;
            return Task.CompletedTask;
        }

        response.ContentLength = asset.Body.Length;
        return HttpMethods.IsGet(request.Method) ? response.Body.WriteAsync(asset.Body, context.RequestAborted).AsTask() : Task.CompletedTask;
    }

    private sealed partial record Asset(byte[] Body, string Type, string Tag, bool IsHashed)
    {
        public static Asset Read(Assembly assembly, string name)
        {
            using Stream stream = assembly.GetManifestResourceStream(name)!;
            byte[] body = new byte[stream.Length];
            stream.ReadExactly(body);
            return new(body, TypeOf(Path.GetExtension(name)), $"\"{Convert.ToHexStringLower(SHA256.HashData(body).AsSpan(0, 16))}\"", HashInName.IsMatch(name));
        }

        // Bundlers give files such names, whose content never changes.
        [GeneratedRegex(@"-[A-Za-z0-9_]{8,}\.\w+$")]
        private static partial Regex HashInName { get; }

        private static string TypeOf(string extension) => new FileExtensionContentTypeProvider().Mappings.TryGetValue(extension, out string? type)
            ? type.StartsWith("text/", StringComparison.Ordinal) ? $"{type}; charset=utf-8" : type
            : "application/octet-stream";
    }
}
