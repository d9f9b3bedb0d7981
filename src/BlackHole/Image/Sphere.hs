-- | Metadata of equirectangular pictures for panorama viewers: the part of the sphere
-- that a picture shows.
--
-- The terms are those of Google's "Photo Sphere XMP Metadata", which VR viewers,
-- photo libraries and players read.
module BlackHole.Image.Sphere
  ( spherePacket,
    isWholeSphere,
  )
where

import BlackHole.Image.Metadata
import BlackHole.Scene.Camera (Projection (..), projectionName)
import BlackHole.Scene.Field.Kind (Value (..))
import BlackHole.Scene.File.SceneFile
import BlackHole.Scene.Setting
import Data.ByteString (ByteString)
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Char8 as Characters

-- | The angle across the width, in degrees, of a tagged picture that is
-- equirectangular.
sphereAngle :: Metadata -> Maybe Double
sphereAngle metadata
  -- Most pictures are not; reading their scenes would take longer than this look.
  | not (Characters.pack name `Bytes.isInfixOf` metadataScene metadata) = Nothing
  | otherwise = case parseSceneFile (metadataScene metadata) of
    Right (file, _)
      | let settings = map placedSetting (fileSettings file),
        NameValue name `elem` valuesOf "camera.projection" settings,
        NumberValue angle : _ <- valuesOf "camera.fov" settings ->
        Just angle
    _ -> Nothing
  where
    name = projectionName Equirectangular
    valuesOf path settings = [settingValue s | s <- settings, settingPath s == path]

-- | Whether a tagged picture of this width and height shows all directions.
isWholeSphere :: Metadata -> (Int, Int) -> Bool
isWholeSphere metadata (width, height) = sphereAngle metadata == Just 360 && width == 2 * height

-- | The XMP packet of a tagged picture of this width and height; 'Nothing' for
-- other projections.
spherePacket :: Metadata -> (Int, Int) -> Maybe ByteString
spherePacket metadata (width, height) = packet <$> sphereAngle metadata
  where
    packet angle =
      Characters.pack . concat $
        [ "<?xpacket begin=\"\xef\xbb\xbf\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>",
          "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF \
          \xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">",
          "<rdf:Description rdf:about=\"\" \
          \xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\""
        ]
          ++ [" GPano:" ++ key ++ "=\"" ++ value ++ "\"" | (key, value) <- properties angle]
          ++ ["/></rdf:RDF></x:xmpmeta><?xpacket end=\"r\"?>"]
    properties angle =
      [ ("ProjectionType", "equirectangular"),
        ("UsePanoramaViewer", "True"),
        ("FullPanoWidthPixels", show fullWidth),
        ("FullPanoHeightPixels", show fullHeight),
        ("CroppedAreaImageWidthPixels", show width),
        ("CroppedAreaImageHeightPixels", show height),
        ("CroppedAreaLeftPixels", show ((fullWidth - width) `quot` 2)),
        ("CroppedAreaTopPixels", show ((fullHeight - height) `quot` 2))
      ]
      where
        fullWidth = max width (round (fromIntegral width * 360 / angle)) :: Int
        fullHeight = max height ((fullWidth + 1) `quot` 2)
