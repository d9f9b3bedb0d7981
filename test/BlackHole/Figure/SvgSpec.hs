module BlackHole.Figure.SvgSpec (spec) where

import BlackHole.Figure.Figure
import BlackHole.Figure.RayFan
import BlackHole.Figure.RayFanFigure
import BlackHole.Figure.Svg
import BlackHole.Vector.XY (XY (..))
import qualified Data.ByteString.Lazy as Lazy
import Data.Char (isAlphaNum, isSpace)
import Data.List (isInfixOf, isPrefixOf, nub, stripPrefix)
import Data.Maybe (fromMaybe)
import Test.Hspec

spec :: Spec
spec = do
  it "is well-formed" $ do
    elements (svg (rayFanFigure defaultRayFan)) `shouldSatisfy` maybe False (not . null)
    elements (svg odd') `shouldSatisfy` maybe False (not . null)
  it "the check for that notices mistakes" $
    map
      elements
      ["<a><b></a>", "<a", "<a x=1/>", "<a>1 & 2</a>", "<a/><b/>", "<a x=\"1\" x=\"2\"/>"]
      `shouldBe` replicate 6 Nothing
  it "has the elements of the figure" $ do
    let names = maybe [] (map fst) (elements (svg (rayFanFigure defaultRayFan)))
    length (filter (== "circle") names) `shouldBe` 3
    length (filter (== "clipPath") names) `shouldBe` 1
    length (filter (== "title") names) `shouldBe` 1
    length (filter (== "path") names) `shouldSatisfy` (> fanRays defaultRayFan)
  it "says its size" $
    case elements (svg (rayFanFigure defaultRayFan {fanWidth = 640})) of
      Just (("svg", attributes) : _) -> do
        lookup "width" attributes `shouldBe` Just "640"
        fmap (take 8) (lookup "viewBox" attributes) `shouldBe` Just "0 0 640 "
        lookup "xmlns" attributes `shouldBe` Just "http://www.w3.org/2000/svg"
      other -> expectationFailure (show other)
  it "writes points with two decimals at most, and escapes text" $ do
    let written = svg odd'
    written `shouldSatisfy` isInfixOf "d=\"M1,2.5 L3.33,0\""
    written `shouldSatisfy` isInfixOf "a &lt; b &amp; c"
    written `shouldSatisfy` isInfixOf "stroke-dasharray=\"3 4\""
  it "gives clipping paths different names" $ do
    let ids =
          [ i
            | ("clipPath", attributes) <- fromMaybe [] (elements (svg odd')),
              Just i <- [lookup "id" attributes]
          ]
    length ids `shouldBe` 3
    nub ids `shouldBe` ids
  where
    -- Everything outside ASCII only ever occurs in text.
    svg = map (toEnum . fromIntegral) . Lazy.unpack . renderSvg
    odd' =
      Figure
        { figureWidth = 10,
          figureHeight = 10,
          figureTitle = "a < b & c \"d\"",
          figureShapes =
            [ Polyline (Stroke (Colour 1 2 255) 0.5 (Just (3, 4))) [XY 1 2.5, XY (10 / 3) (-0.001)],
              Polyline (Stroke (Colour 1 2 255) 0.5 Nothing) [],
              Clipped
                (Box 0 0 5 5)
                [ Clipped (Box 0 0 5 5) [Disc (Colour 0 0 0) (XY 1 1) 2],
                  Polygon (Colour 9 9 9) [XY 0 0, XY 1 0, XY 0 1]
                ],
              Clipped (Box 0 0 5 5) [Ring (Stroke (Colour 0 0 0) 1 Nothing) (XY 1 1) 2],
              Words
                ( Label
                    (XY 1 1)
                    AtEnd
                    8
                    (Colour 0 0 0)
                    True
                    [Plain "a < b & c", Subscript "\8722", Plain " d"]
                )
            ]
        }

-- | Names and attributes of all elements of a document, in order of their
-- opening: 'Nothing' unless tags nest, attributes are quoted and not repeated,
-- and there is one outermost element.
elements :: String -> Maybe [(String, [(String, String)])]
elements document =
  go [] [] (maybe document (drop 1 . dropWhile (/= '>')) (stripPrefix "<?xml" document))
  where
    go ::
      [String] -> [(String, [(String, String)])] -> String -> Maybe [(String, [(String, String)])]
    go stack done s = case s of
      "" | null stack -> Just (reverse done)
      '<' : '/' : rest -> case (span isName rest, stack) of
        ((name, '>' : more), top : below) | name == top -> go below done more
        _ -> Nothing
      '<' : rest
        | null stack && not (null done) -> Nothing
        | (name@(_ : _), more) <- span isName rest -> do
          (found, end) <- attributes [] more
          case end of
            '/' : '>' : more' -> go stack ((name, found) : done) more'
            '>' : more' -> go (name : stack) ((name, found) : done) more'
            _ -> Nothing
      '&' : rest
        | any (`isPrefixOf` rest) ["amp;", "lt;", "gt;", "quot;"] -> go stack done rest
      c : rest
        | c `notElem` "<&", not (null stack) || isSpace c -> go stack done rest
      _ -> Nothing
    attributes found s = case s of
      ' ' : rest
        | (name@(_ : _), '=' : '"' : more) <- span isName rest,
          (content, '"' : others) <- break (`elem` "\"<") more,
          name `notElem` map fst found ->
          attributes (found ++ [(name, content)]) others
      _
        | any (`isPrefixOf` s) [">", "/>"] -> Just (found, s)
        | otherwise -> Nothing
    isName c = isAlphaNum c || c `elem` "-:_"
