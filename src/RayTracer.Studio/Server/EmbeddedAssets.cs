using System.Collections.Frozen;
using System.Reflection;
using System.Security.Cryptography;
using System.Text;

namespace RayTracer.Studio;

/// <summary>The pages, which are within the program. They are found by their exact names only: there is no path that could lead elsewhere.</summary>
internal sealed class EmbeddedAssets
{
    private const string Prefix = "wwwroot/";
    private const string Start = "/index.html";

    // In the page, this is replaced by a number used once, with which its scripts may mark their own style sheets.
    private const string NoncePlace = "__STYLE_NONCE__";

    // Vite gives these names that hold a hash of their content, so they never change.
    private const string Hashed = "/assets/";
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
        return path == Start ? SendStart(context, asset) : SendFile(context, asset, path.StartsWith(Hashed, StringComparison.Ordinal));
    }

    private static Task SendStart(HttpContext context, Asset page)
    {
        string nonce = Convert.ToHexStringLower(RandomNumberGenerator.GetBytes(16));
        context.Response.Headers.ContentSecurityPolicy = ContentPolicy.Header(nonce);
        context.Response.Headers.CacheControl = "no-store";
        byte[] body = Encoding.UTF8.GetBytes(Encoding.UTF8.GetString(page.Body).Replace(NoncePlace, nonce, StringComparison.Ordinal));
        return Send(context, body);
    }

    private static Task SendFile(HttpContext context, Asset asset, bool isHashed)
    {
        context.Response.Headers.ETag = asset.Tag;
        context.Response.Headers.CacheControl = isHashed ? "public, max-age=31536000, immutable" : "no-cache";
        if (context.Request.Headers.IfNoneMatch == asset.Tag)
        {
            context.Response.StatusCode = StatusCodes.Status304NotModified;
            return Task.CompletedTask;
        }

        return Send(context, asset.Body);
    }

    private static Task Send(HttpContext context, byte[] body)
    {
        context.Response.ContentLength = body.Length;
        return HttpMethods.IsGet(context.Request.Method) ? context.Response.Body.WriteAsync(body, context.RequestAborted).AsTask() : Task.CompletedTask;
    }

    private sealed record Asset(byte[] Body, string Type, string Tag)
    {
        public static Asset Read(Assembly assembly, string name)
        {
            using Stream stream = assembly.GetManifestResourceStream(name)!;
            byte[] body = new byte[stream.Length];
            stream.ReadExactly(body);
            return new(body, TypeOf(Path.GetExtension(name)), $"\"{Convert.ToHexStringLower(SHA256.HashData(body).AsSpan(0, 16))}\"");
        }

        private static string TypeOf(string extension) => extension switch
        {
            ".html" => "text/html; charset=utf-8",
            ".js" => "text/javascript; charset=utf-8",
            ".css" => "text/css; charset=utf-8",
            ".json" or ".map" => "application/json",
            ".svg" => "image/svg+xml",
            ".png" => "image/png",
            ".woff2" => "font/woff2",
            _ => "application/octet-stream",
        };
    }
}
